package cga.grading.reading

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import cga.grading.study.DrawVertices
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_BOOL
import org.lwjgl.opengl.GL33C.GL_INT
import org.lwjgl.opengl.GL33C.GL_UNSIGNED_INT
import kotlin.math.abs

/** A program as some draws use it: with these whole numbers and truth values, by which it may do one thing or another. */
internal data class Variant(val program: Int, val switches: List<Pair<String, List<Float>>>) {
    companion object {
        fun of(draw: CapturedDraw): Variant =
            Variant(draw.program, draw.uniforms.filter { it.type in WHOLE }.map { it.name to it.numbers.toList() })

        private val WHOLE = setOf(GL_INT, GL_BOOL, GL_UNSIGNED_INT)
    }
}

/** What every program of a capture computes, and with that what every picture shows. */
internal class CaptureReading(private val capture: Capture) {
    private val failures = LinkedHashMap<Variant, String>()

    /** By variant, those that could be read. */
    val programs: Map<Variant, ProgramReading> = capture.draws
        .map(Variant::of)
        .distinct()
        .take(MOST)
        .mapNotNull { variant ->
            read(variant)?.let {
                variant to
                    it
            }
        }.toMap()
    val lights: Map<Variant, List<LightReading>> = programs.mapValues { (_, program) -> LightFinder(program).find() }
    private val readers = programs.mapValues { (variant, program) -> DrawReader(program, lights.getValue(variant)) }
    private val meshes = HashMap<List<Any?>, FloatArray>()

    /** Why programs could not be read. */
    val notes: List<String> get() = failures.map { (variant, why) -> "program ${variant.program}: $why" }

    private fun read(variant: Variant): ProgramReading? =
        try {
            ProgramReading
                .of(
                    capture,
                    variant.program,
                    capture.frames.map { frame ->
                        frame.draws.filter { Variant.of(it) == variant }
                    },
                ).also {
                    if (it ==
                        null
                    ) {
                        failures[variant] = "no picture comes of its vertices"
                    }
                }
        } catch (e: Unreadable) {
            failures[variant] = checkNotNull(e.message)
            null
        }

    private inner class Seen(val draw: CapturedDraw, val variant: Variant, val spaces: Spaces) {
        val reading = programs.getValue(variant)
        val vertices = vertices(draw, reading.position)
        val tint: Vector3d? by lazy { tint(this) }
    }

    /** What [frame] shows; null where none of its draws is understood. */
    fun observe(frame: CapturedFrame): ObservedFrame? {
        val seen = frame.draws.mapNotNull(::look)
        val lit = seen.filter { lights.getValue(it.variant).isNotEmpty() }
        val last = lit.lastOrNull() ?: seen.lastOrNull() ?: return null
        val view = lit.firstNotNullOfOrNull { it.spaces.view } ?: seen.maxBy { extent(it.vertices) }.spaces.modelView
        val lights = seen.associateWith { lights(it, view) }
        val objects = seen.groupBy { listOf(rounded(model(it, view)), it.tint) }.values.map { same ->
            ObservedObject(
                model(same[0], view),
                same[0].tint,
                lights.getValue(same.last()),
                joined(same.map { it.vertices }),
                same.flatMap { it.draw.attributes.map { a -> a.buffer } }.distinct(),
            )
        }
        return ObservedFrame(frame.moment, frame.time, view, last.spaces.projection, objects, lights.getValue(last))
    }

    private fun look(draw: CapturedDraw): Seen? {
        val variant = Variant.of(draw)
        val spaces = programs[variant]?.spaceFinder?.of(ProgramReading.values(draw)) ?: return null
        return Seen(draw, variant, spaces)
    }

    private fun lights(seen: Seen, view: Matrix4dc): List<ObservedLight> {
        val spaces = if (seen.spaces.view !=
            null
        ) {
            seen.spaces
        } else {
            Spaces(seen.spaces.projection, seen.spaces.modelView, view, seen.spaces.model)
        }
        return readers.getValue(seen.variant).lights(seen.draw, spaces)
    }

    private fun tint(seen: Seen): Vector3d? = Emission.of(seen.reading, lights.getValue(seen.variant)).tint?.let { nodes ->
        val values = ProgramReading.values(seen.draw)
        val numbers = nodes.map { node ->
            (node.source as? cga.reader.shader.Source.Uniform)?.let { values[it.slot.name]?.getOrNull(it.component) }
                ?: node.value
        }
        Vector3d(numbers.toDoubleArray())
    }

    private fun model(seen: Seen, view: Matrix4dc): Matrix4dc = seen.spaces.model ?: view.invert(Matrix4d()).mul(seen.spaces.modelView)

    private fun rounded(m: Matrix4dc) = m.get(DoubleArray(16)).map { Math.round(it * 1e4) }

    private fun extent(vertices: FloatArray): Float = vertices.maxOfOrNull { abs(it) } ?: 0f

    private fun vertices(draw: CapturedDraw, position: Int): FloatArray {
        val attribute = draw.attributes.find { it.location == position } ?: return FloatArray(0)
        val key = listOf(attribute.buffer, attribute.offset, attribute.stride, draw.indices, draw.first, draw.count, draw.baseVertex)
        return meshes.getOrPut(key) {
            val read = DrawVertices(capture, draw)
            val all = read.distinct.map { read.read(position, it) ?: DoubleArray(4) }
            FloatArray(3 * all.size) { all[it / 3][it % 3].toFloat() }
        }
    }

    private fun joined(parts: List<FloatArray>): FloatArray =
        if (parts.size == 1) parts[0] else meshes.getOrPut(parts.map { System.identityHashCode(it) }) { parts.reduce(FloatArray::plus) }

    private companion object {
        const val MOST = 12
    }
}
