package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.max
import kotlin.random.Random

/** Takes apart a contribution that is the sum of several lights at known places: one colour given to all of them. */
internal object SharedColor {
    /**
     * The lights among [candidates] (view space) whose clamped cosines add up to what [probe] shows at [points]; empty where they do not,
     * or where one alone does.
     */
    fun of(
        probe: LightProbe,
        points: List<Vector3dc>,
        candidates: List<Vector3d>,
        texels: Map<String, Double>,
    ): List<SharedLight> {
        val random = Random(12)
        val different = candidates.filterIndexed { i, c -> candidates.take(i).none { it.distance(c) < 1e-4 } }
        val places = shining(probe, different.take(MOST), texels).take(MOST_LIGHTS)
        if (places.size < 2 || !isSum(probe, points.take(FIRST), places, texels)) return emptyList()
        val around =
            points + places.flatMap { c -> List(AROUND) { Vector3d(Directions.random(random)).mul(random.nextDouble(0.5, 4.0)).add(c) } }
        val normals = around.map { List(NORMALS) { Directions.random(random) } }
        val values = probe.shade(around.indices.flatMap { i -> normals[i].map { Sample(around[i], it) } }, texels)
        val strengths = around.indices.map { i -> strengths(around[i], normals[i], places) { values[NORMALS * i + it] } }
        val misfit = misfit(strengths)
        if (misfit > ACCEPTED) return emptyList()
        val total = strengths.sumOf { it.perPlace.sum() }
        val shining = places.indices.filter { c -> strengths.sumOf { it.perPlace[c] } > 1e-3 * total }
        if (shining.size < 2) return emptyList()
        return shining.map { c ->
            // Far away its share of the sum is small, and what is found of it inexact.
            val measured = around.indices.filter { strengths[it].perPlace[c] > 1e-3 && around[it].distance(places[c]) < NEAR }
            val distances = DoubleArray(measured.size) { around[measured[it]].distance(places[c]) }
            val law = if (measured.size <
                8
            ) {
                null
            } else {
                AttenuationFit.of(distances, DoubleArray(measured.size) { strengths[measured[it]].perPlace[c] }, growing = false)
            }
            SharedLight(places[c], law)
        }
    }

    /** Those of [places] with a light: what faces it on one side of it is dark on the other, and nothing else changes that fast. */
    private fun shining(
        probe: LightProbe,
        places: List<Vector3d>,
        texels: Map<String, Double>,
    ): List<Vector3d> {
        // As many as a narrow cone needs to be met.
        val around = Directions.sphere(ALL_AROUND)
        val samples = places.flatMap { c -> around.flatMap { n -> SIDES.map { Sample(Vector3d(c).fma(it, n), n) } } }
        val shades = probe.shade(samples, texels)
        val per = 2 * ALL_AROUND
        val jumps = places.indices.map { c ->
            around.indices.maxOf {
                val (bright, dark) = shades[per * c + 2 * it] to shades[per * c + 2 * it + 1]
                if (dark < MOSTLY_DARK * bright) bright - dark else 0.0
            }
        }
        val largest = jumps.filter { it.isFinite() }.maxOrNull() ?: return emptyList()
        return places.filterIndexed { c, _ -> jumps[c] > JUMP * largest && jumps[c] > 0 }
    }

    /** Whether a look at a few [points] leaves it possible: the whole one takes seconds. */
    private fun isSum(
        probe: LightProbe,
        points: List<Vector3dc>,
        places: List<Vector3d>,
        texels: Map<String, Double>,
    ): Boolean {
        val random = Random(18)
        val normals = List(NORMALS) { Directions.random(random) }
        val values = probe.shade(points.flatMap { p -> normals.map { Sample(p, it) } }, texels)
        return misfit(points.indices.map { i -> strengths(points[i], normals, places) { values[NORMALS * i + it] } }) <= ACCEPTED
    }

    private fun misfit(strengths: List<Strengths>) = strengths.sumOf { it.misfit } / max(strengths.sumOf { it.sum }, 1e-300)

    private class Strengths(
        val perPlace: DoubleArray,
        val misfit: Double,
        val sum: Double,
    )

    /** Non-negative strengths of lights at [places] that explain the values for [normals] at [point], by coordinate descent. */
    private fun strengths(
        point: Vector3dc,
        normals: List<Vector3d>,
        places: List<Vector3d>,
        value: (Int) -> Double,
    ): Strengths {
        val cosines = places.map { c ->
            Vector3d(c).sub(point).normalize().let { l -> DoubleArray(normals.size) { max(normals[it].dot(l), 0.0) } }
        }
        val rest = DoubleArray(normals.size) { value(it).let { v -> if (v.isFinite()) v else 0.0 } }
        val sum = rest.sumOf { abs(it) }
        val strengths = DoubleArray(places.size)
        val squares = DoubleArray(places.size) { c -> cosines[c].sumOf { it * it } }
        repeat(ROUNDS) {
            var change = 0.0
            for (c in places.indices) {
                if (!(squares[c] > 0)) continue
                val better = max(strengths[c] + rest.indices.sumOf { rest[it] * cosines[c][it] } / squares[c], 0.0)
                change += abs(better - strengths[c])
                for (i in rest.indices) rest[i] -= (better - strengths[c]) * cosines[c][i]
                strengths[c] = better
            }
            if (change <= SETTLED * sum) return Strengths(strengths, rest.sumOf { abs(it) }, sum)
        }
        return Strengths(strengths, rest.sumOf { abs(it) }, sum)
    }

    private const val FIRST = 6

    /** View-space units: so near that a light's distance changes nothing of its strength. */
    private val SIDES = listOf(-0.02, 0.02)
    private const val ALL_AROUND = 150
    private const val JUMP = 0.1

    /** Of the bright side: what a light farther away leaves on the other. */
    private const val MOSTLY_DARK = 0.7
    private const val NEAR = 5.0
    private const val MOST = 400
    private const val MOST_LIGHTS = 40
    private const val AROUND = 12
    private const val NORMALS = 64
    private const val ROUNDS = 400
    private const val SETTLED = 1e-8
    private const val ACCEPTED = 1e-2
}
