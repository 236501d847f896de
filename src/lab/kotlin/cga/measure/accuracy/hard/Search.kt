package cga.measure.accuracy.hard

import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.abs
import kotlin.random.Random

/** Shades random shots and judges each pixel. */
internal class Search(
    private val probe: Probe,
    seed: Long,
) {
    private val shots = RandomShots(Random(seed))
    private var compared = 0
    private var notFinite = 0
    private var beyondBound = 0
    private var worst = 0.0
    private var worstShot = ""
    private val findings = mutableListOf<String>()

    fun run(evaluations: Int): SearchResult {
        var left = evaluations
        while (left > 0) {
            val batch = List(minOf(left, BATCH)) { shots.next() }
            batch.zip(probe.shade(batch)).forEach { (shot, color) -> judge(shot, color) }
            left -= batch.size
        }
        val shown = findings.ifEmpty { listOf(worstShot) }
        return SearchResult(evaluations, compared, notFinite, beyondBound, worst, shown)
    }

    private fun judge(
        shot: Shot,
        color: Vector3f,
    ) {
        if (!color.isFinite) {
            notFinite++
            report(shot, color, "not finite")
            return
        }
        val truth = shot.truth()
        val bound = ShotBound.of(shot, truth) ?: return
        compared++
        val error = (0..2).maxOf { abs(color[it] - truth.color[it]) }
        if (error / bound > worst) {
            worst = error / bound
            worstShot = describe(shot, color, "error $error, bound $bound")
        }
        if (error > bound) {
            beyondBound++
            report(shot, color, "off by $error, more than $bound; truth ${truth.color.x}")
        }
    }

    private fun report(
        shot: Shot,
        color: Vector3f,
        what: String,
    ) {
        if (findings.size < SHOWN) findings += describe(shot, color, what)
    }

    private fun describe(
        shot: Shot,
        color: Vector3f,
        what: String,
    ): String {
        val lights = shot.lights.joinToString { "at ${it.getPosition()}, L ${it.lightColor}, K ${it.attenuation}" }
        val surface = "at ${exact(shot.position)}, n ${exact(shot.normal)}"
        return "$what: ${exact(color)} of ${shot.specularModel}, k ${shot.k}, $surface; lights $lights"
    }

    private fun exact(v: Vector3fc) = "(${v.x()}, ${v.y()}, ${v.z()})"

    private companion object {
        const val BATCH = 1 shl 16
        const val SHOWN = 10
    }
}
