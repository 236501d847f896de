package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.exp
import kotlin.random.Random

/** Places lights whose directions cannot be read off a clamped cosine, by trying out where the numbers that were sent would put them. */
internal object HintPlacement {
    /**
     * Of [hints] (view space) the one for which the term [peak] is brightest where it should be, around the light and at the points [lit];
     * null where none is.
     */
    fun of(
        probe: LightProbe,
        hints: List<Vector3d>,
        lit: List<Vector3d>,
        texels: Map<String, Double>,
        peak: Peak,
    ): Placement? {
        val best = distinct(hints)
            .map { hint ->
                Placement.inView(probe.box.spaces, hint).let { it to score(probe, it, lit, texels, peak) }
            }.maxByOrNull { it.second }
        return best?.takeIf { it.second > CONVINCING }?.first
    }

    /** Where a light may be of which nothing else is known: near which of [hints] it is brightest. */
    fun guess(
        probe: LightProbe,
        hints: List<Vector3d>,
        texels: Map<String, Double>,
    ): Vector3d? {
        val random = Random(17)
        val samples = List(AROUND) { Sample(Directions.random(random).mul(NEAR), Directions.random(random)) }
        return distinct(hints).maxByOrNull { hint ->
            val shades = probe.shade(samples.map { Sample(Vector3d(it.position).add(hint), it.normal) }, texels)
            shades.sumOf { if (it.isFinite()) abs(it) else 0.0 }
        }
    }

    private fun distinct(hints: List<Vector3d>) = hints
        .filterIndexed { i, hint ->
            hints
                .take(
                    i,
                ).none { it.distance(hint) < 1e-4 }
        }.take(MOST)

    /** The share of the lit points at which no normal beside the one expected is brighter. */
    private fun score(
        probe: LightProbe,
        placement: Placement,
        lit: List<Vector3d>,
        texels: Map<String, Double>,
        peak: Peak,
    ): Double {
        val random = Random(16)
        val around = List(AROUND) { placement.at(Directions.random(random).mul(exp(random.nextDouble(-0.7, 1.4)))) }
        val points: List<Vector3dc> = around + lit
        val samples =
            points.flatMap { p ->
                val n = Amplitudes.towards(placement, p, peak)
                (listOf(n) + List(BESIDE) { Directions.around(n, TILT, 1.6 * it) }).map { Sample(p, placement.normalFor(it)) }
            }
        val shades = probe.shade(samples, texels)
        val per = BESIDE + 1
        val shining = points.indices.filter { shades[per * it] > 0 && shades[per * it].isFinite() }
        if (shining.size < ENOUGH) return 0.0
        return shining.count { i -> (1..BESIDE).all { shades[per * i + it] < shades[per * i] } }.toDouble() / shining.size
    }

    private const val MOST = 40
    private const val AROUND = 60
    private const val NEAR = 0.5
    private const val BESIDE = 4
    private const val TILT = 0.05
    private const val ENOUGH = 6
    private const val CONVINCING = 0.9
}
