package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import kotlin.math.abs

/**
 * Tells captured frames in the terms of the scene, by what [studies] found out about the programs.
 *
 * @param studies by number of the program; draws of others are left out.
 */
internal class Observations(
    private val capture: Capture,
    private val studies: Map<Int, ProgramStudy>,
) {
    private val refs = studies.mapValues { (_, study) -> study.lights.flatMap { LightRefs.of(it, study) } }
    private val idle = studies.mapValues { (number, study) -> IdleElements.of(study, refs.getValue(number)) }
    private val positions = HashMap<List<Any?>, FloatArray>()

    private class Seen(
        val draw: CapturedDraw,
        val spaces: Spaces,
        val values: Map<String, FloatArray>,
        val study: ProgramStudy,
    )

    /** What [frame] shows; null where none of its draws is understood. */
    fun of(frame: CapturedFrame): ObservedFrame? {
        val seen = withoutInsets(frame.draws.mapNotNull(::look))
        // What no light falls on, sparks or a trail, may be drawn after all else.
        val last = seen.lastOrNull { it.study.lights.isNotEmpty() } ?: seen.lastOrNull() ?: return null
        val view = seen.firstNotNullOfOrNull { it.spaces.view } ?: groundView(seen)
        val passes = LightPasses.of(seen.map { it.draw to model(it, view) })
        val added = if (passes.size > 1) passes.map { lights(seen[it.last()], view) } else null
        val lights = seen.associateWith { added?.let(::together) ?: lights(it, view) }
        val objects =
            passes.first().map(seen::get).groupBy { key(it, view) }.map { (_, same) ->
                val program = same.first().study
                val tint = program.emission.tint?.let { same.first().values[it.name] }
                ObservedObject(
                    model = model(same.first(), view),
                    tint = tint?.let { Vector3d(it[0].toDouble(), it[1].toDouble(), it[2].toDouble()) },
                    lights = lights.getValue(same.last()),
                    vertices = same.map(::vertices).let { all -> if (all.size == 1) all[0] else joined(all) },
                    buffers = same.flatMap { it.draw.attributes.map { a -> a.buffer } }.distinct(),
                    isTintWritten = program.emission.tint?.name in program.box.program.constants,
                )
            }
        return ObservedFrame(
            frame.moment, frame.time, view, last.spaces.projection, objects, lights.getValue(last), idle(last, view),
        )
    }

    /** [all] without a second look at the same things in a corner of the picture: a map, a mirror. */
    private fun withoutInsets(all: List<Seen>): List<Seen> {
        val largest = all.maxOfOrNull(::area) ?: return all
        val (main, insets) = all.partition { area(it) == largest }
        val things = main.map(::thing).toSet()
        return if (insets.all { inset -> thing(inset)?.let(things::contains) == true }) main else all
    }

    private fun area(seen: Seen): Int = seen.draw.state.viewport.let { it[2] * it[3] }

    private fun thing(seen: Seen): List<Any?>? = seen.spaces.model?.let { LightPasses.thing(seen.draw, it) + seen.draw.program }

    private fun look(draw: CapturedDraw): Seen? {
        val study = studies[draw.program] ?: return null
        val values = study.box.program.values(draw)
        val spaces = Spaces.of(study.formula, study.box.program.matrices.filter { it in values }, values) ?: return null
        return Seen(draw, spaces, values, study)
    }

    /** Without a view matrix the widest thing drawn, the ground, is taken to lie in the world as it is. */
    private fun groundView(seen: List<Seen>): Matrix4dc = seen.maxBy { extent(vertices(it)) }.spaces.modelView

    private fun extent(vertices: FloatArray): Float = vertices.maxOfOrNull { abs(it) } ?: 0f

    private fun model(
        seen: Seen,
        view: Matrix4dc,
    ): Matrix4dc = seen.spaces.model ?: view.invert(Matrix4d()).mul(seen.spaces.modelView)

    /** What draws of one object have in common: model matrix and tint. */
    private fun key(
        seen: Seen,
        view: Matrix4dc,
    ): List<Any> {
        val tint = seen.study.emission.tint?.let { seen.values[it.name]?.toList() } ?: emptyList<Float>()
        return Spaces.rounded(model(seen, view)) + tint
    }

    private fun idle(seen: Seen, view: Matrix4dc): List<ObservedLight> =
        idle.getValue(seen.draw.program).map { it.light(seen.values, seen.spaces.view ?: view, seen.spaces) }

    private fun lights(
        seen: Seen,
        view: Matrix4dc,
    ): List<ObservedLight> = refs.getValue(seen.draw.program).map { it.light(seen.values, seen.spaces.view ?: view, seen.spaces) }

    /** The lights of all [passes]; where two have the same name, as one shader is drawn with for each light, they are numbered. */
    private fun together(passes: List<List<ObservedLight>>): List<ObservedLight> {
        val names = passes.flatten().groupingBy { it.name }.eachCount()
        return passes.flatMapIndexed { pass, lights ->
            lights.map { if (names[it.name] == 1) it else it.named("${it.name} of pass ${pass + 1}") }
        }
    }

    private fun vertices(seen: Seen): FloatArray {
        val location = seen.study.formula.positionLocation
        val attribute = seen.draw.attributes.find { it.location == location } ?: return FloatArray(0)
        val key =
            with(seen.draw) { listOf(attribute.buffer, attribute.offset, attribute.stride, indices, first, count, baseVertex) }
        return positions.getOrPut(key) {
            val vertices = DrawVertices(capture, seen.draw)
            val all = vertices.distinct.map { vertices.read(location, it) ?: DoubleArray(4) }
            FloatArray(3 * all.size) { all[it / 3][it % 3].toFloat() }
        }
    }

    private fun joined(parts: List<FloatArray>): FloatArray {
        val key: List<Any?> = parts.map { System.identityHashCode(it) }
        return positions.getOrPut(key) {
            val result = FloatArray(parts.sumOf { it.size })
            var at = 0
            for (part in parts) {
                part.copyInto(result, at)
                at += part.size
            }
            result
        }
    }
}
