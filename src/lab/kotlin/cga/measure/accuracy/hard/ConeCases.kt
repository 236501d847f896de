package cga.measure.accuracy.hard

import cga.exercise.components.light.SpotLight
import org.joml.Vector3d
import org.joml.Vector3f
import kotlin.math.abs
import kotlin.math.cos

/** Spotlights from a half space down to a laser. */
internal class ConeCases(private val probe: Probe) {
    fun measure(): List<HardCase> = DEGREES.map(::cone) + hardEdge()

    /** The inner angle is half of the outer one; the light stands at the origin, turned, and the points lie from its axis to its edge. */
    private fun cone(degrees: Double): HardCase {
        val outer = Math.toRadians(degrees).toFloat()
        val light = light(outer / 2, outer)
        val shots = (0..SHARES).map { facing(light, it * outer.toDouble() / SHARES) }
        val seen = probe.shade(shots)
        val naive = shots.maxOf { shot -> abs(shot.truth().lights.single().cone - naive(light, shot, outer / 2, outer)) }
        val ours = shots.indices.maxOf { abs(shots[it].truth().color.x - seen[it].x) }
        return HardCase(
            name = "cone of ${plain(degrees)}°",
            naive = "float cosines",
            naiveError = 255 * naive,
            ours = "versines, |l − s|²/2",
            ourError = 255 * ours,
            bound = 255 * (Rounding.cone(outer / 2.0, outer.toDouble()) + Rounding.COSINE + Rounding.PRODUCTS),
            unit = ErrorUnit.COLOR,
            failure = if (degrees < 0.5) "both cosines round to nearly 1" else "",
        )
    }

    /** inner = outer: on the edge the naive form divides 0 by 0. */
    private fun hardEdge(): HardCase {
        val edge = Math.toRadians(30.0).toFloat()
        val light = light(edge, edge)
        val shots = listOf(0.0, 0.9999, 1.0001, 2.0).map { facing(light, it * edge) }
        val seen = probe.shade(shots)
        val cosEdge = cos(edge)
        return HardCase(
            name = "inner = outer",
            naive = "(cos θ − cos φ) / (cos γ − cos φ)",
            naiveError = ((cosEdge - cosEdge) / (cosEdge - cosEdge)).toDouble(),
            ours = "a step at the edge",
            ourError = 255 * shots.indices.maxOf { abs(shots[it].truth().color.x - seen[it].x) },
            bound = 255 * (Rounding.COSINE + Rounding.PRODUCTS),
            unit = ErrorUnit.COLOR,
            failure = "0/0 on the edge",
        )
    }

    private fun light(
        inner: Float,
        outer: Float,
    ) = SpotLight(Vector3f(), Vector3f(1f), inner, outer, Vector3f(1f, 0f, 0f)).apply { rotateLocal(0.7f, -1.1f, 0.3f) }

    /** A white point at this angle from the axis, 3 away, with its face to the light: its colour is I. */
    private fun facing(
        light: SpotLight,
        angle: Double,
    ): Shot {
        val axis = light.getDirection(Vector3d())
        val across = Vector3d(axis).cross(0.6, 0.0, 0.8).normalize()
        val position = Vector3f(axis.rotateAxis(angle, across.x, across.y, across.z).mul(3.0))
        return Shot(position = position, normal = position.negate(Vector3f()), lights = listOf(light))
    }

    private fun naive(
        light: SpotLight,
        shot: Shot,
        inner: Float,
        outer: Float,
    ): Double {
        val intensity = Naive.cone(shot.position, Vector3f(light.getDirection(Vector3d())), inner, outer)
        // Where both cosines are 1, 0/0: as wrong as it can be.
        return if (intensity.isFinite()) {
            intensity.toDouble()
        } else if (shot.truth().lights.single().cone > 0.5) {
            0.0
        } else {
            1.0
        }
    }

    private fun plain(degrees: Double) = degrees.toBigDecimal().stripTrailingZeros().toPlainString()

    internal companion object {
        /** Outer angles. */
        val DEGREES: List<Double> = listOf(90.0, 30.0, 1.0, 0.1, 0.01, 0.001)
        private const val SHARES = 500
    }
}
