package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Matrix4d
import org.joml.Vector3d
import kotlin.math.abs

/**
 * Light that has no place: a sun, or a sky above and a ground below. It is the same wherever the surface is, and comes from a direction that
 * stays in the world while the camera turns. The sheet asks for none and forbids none.
 *
 * A lamp whose place is mistaken for a direction is alike everywhere as well, but turns with the camera.
 */
internal object Suns {
    /** Which of the lights of [colors] are that, for program [number] of [capture]; none where the camera never turns. */
    fun among(
        box: BlackBox,
        colors: ColorSlots,
        formula: GeometryFormula,
        capture: Capture,
        number: Int,
    ): Set<ActiveUniform> {
        val alike = colors.lights.filter { matte(LightProbe(box, it, colors)) != null }
        // Where all are alike it is their distance that is wrong.
        if (alike.isEmpty() || alike.size == colors.lights.size) return emptySet()
        val (one, other) = turned(box, formula, capture, number) ?: return emptySet()
        return alike
            .filter { slot ->
                val here = one.direction(slot, colors)
                val there = other.direction(slot, colors)
                here != null && there != null && here.distance(there) < STAYS
            }.toSet()
    }

    /** The textures with which the light is the same from wherever it is seen; null where that is so with none, or only from some distances. */
    private fun matte(probe: LightProbe): Map<String, Double>? {
        val samplers = probe.box.program.samplers.map { it.name }
        val white = samplers.associateWith { 1.0 }
        if (!isAlike(probe.gradients(RAY, white))) return null
        if (samplers.isEmpty()) return white.takeIf { isAlike(probe.gradients(RAY + BESIDE, white)) }
        return samplers
            .map { only -> samplers.associateWith { if (it == only) 1.0 else 0.0 } }
            .firstOrNull { isAlike(probe.gradients(RAY + BESIDE, it)) }
    }

    private fun isAlike(gradients: List<Gradient>): Boolean {
        val first = gradients.first()
        return first.strength > 0 && gradients.all {
            it.direction.distance(first.direction) <= ALIKE * first.strength && abs(it.floor - first.floor) <= ALIKE * first.strength
        }
    }

    /** A draw as a function, and how the world is turned in its picture. */
    private class Turned(
        val box: BlackBox,
        val rotation: Matrix3dc,
    ) {
        /** Where the light of [slot] comes from in the world; null where it does not shine. */
        fun direction(
            slot: ActiveUniform,
            colors: ColorSlots,
        ): Vector3d? {
            val probe = LightProbe(box, slot, colors)
            val texels = matte(probe) ?: return null
            // By normals along the world's axes: where a wrong normal matrix bends them it does so alike in every picture.
            val shades = probe.shade(Directions.AXES.map { Sample(RAY[0], rotation.transform(it, Vector3d())) }, texels)
            val towards = Vector3d()
            Directions.AXES.forEachIndexed { i, axis -> towards.fma(shades[i], axis) }
            return towards.normalize()
        }
    }

    /** Two draws of the widest object between which the camera has turned most; null where it never does. */
    private fun turned(
        box: BlackBox,
        formula: GeometryFormula,
        capture: Capture,
        number: Int,
    ): Pair<Turned, Turned>? {
        // The same mesh may be drawn as several objects: the order in the picture tells them apart.
        val objects = capture.frames
            .flatMap { frame ->
                val draws = frame.drawsOf(number)
                draws.groupBy(::mesh).flatMap { (mesh, same) -> same.mapIndexed { i, draw -> (mesh to i) to draw } }
            }.groupBy({ it.first }, { it.second })
        val all = objects.values.maxByOrNull { same -> extent(box, formula, capture, same.first()) } ?: return null
        val turned = all.mapNotNull { draw ->
            val values = box.program.values(draw)
            val spaces = Spaces.of(formula, box.program.matrices.filter { it in values }, values) ?: return@mapNotNull null
            Turned(box.drawn(spaces, values), Matrix3d((spaces.view ?: spaces.modelView).normalize3x3(Matrix4d())))
        }
        val first = turned.firstOrNull() ?: return null
        val other = turned.maxBy { apart(it.rotation, first.rotation) }
        return (first to other).takeIf { apart(first.rotation, other.rotation) > TURNS }
    }

    private fun mesh(draw: CapturedDraw) = listOf(draw.attributes.map { it.buffer to it.offset }, draw.indices, draw.first, draw.count)

    /** How far the object's points are from its own origin, in view space. */
    private fun extent(
        box: BlackBox,
        formula: GeometryFormula,
        capture: Capture,
        draw: CapturedDraw,
    ): Double {
        val values = box.program.values(draw)
        val spaces = Spaces.of(formula, box.program.matrices.filter { it in values }, values) ?: return 0.0
        val vertices = DrawVertices(capture, draw)
        return vertices.distinct.maxOfOrNull { v ->
            val at = vertices.read(formula.positionLocation, v)?.let { Vector3d(it[0], it[1], it[2]) } ?: return@maxOfOrNull 0.0
            spaces.modelView.transformDirection(at).length()
        } ?: 0.0
    }

    private fun apart(
        a: Matrix3dc,
        b: Matrix3dc,
    ) = listOf(Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, 0.0, 1.0)).maxOf { a.transform(it, Vector3d()).distance(b.transform(it, Vector3d())) }

    /** View space: on one ray from the eye, so that only the distance changes, and beside it. */
    private val RAY = listOf(1.5, 4.0, 11.0).map { Vector3d(0.3, -0.4, -1.0).mul(it) }
    private val BESIDE = listOf(Vector3d(4.0, 1.0, -5.0), Vector3d(-2.0, 3.0, -9.0))

    /** Relative; floats give 1e-6. */
    private const val ALIKE = 1e-3

    /** Of unit vectors, a twentieth of a degree. */
    private const val STAYS = 1e-3
    private const val TURNS = 0.05
}
