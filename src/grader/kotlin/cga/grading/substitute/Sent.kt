package cga.grading.substitute

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.UniformValue
import org.joml.Matrix4d
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT_MAT4

/** Everything that was sent to one program: its draws, frame by frame. */
internal class Sent(
    capture: Capture,
    program: Int,
) {
    val frames: List<List<Sending>> =
        capture.frames.map { frame -> frame.drawsOf(program).map(::Sending) }.filter { it.isNotEmpty() }

    /** The very last draw: what is sent is complete by then. */
    val last: Sending get() = frames.last().last()

    /** What is drawn in every frame. */
    val meshes: List<List<Any?>> by lazy {
        frames.map { frame -> frame.map { it.mesh } }.reduceOrNull { a, b -> a.filter { it in b } }.orEmpty().distinct()
    }

    /** Name and OpenGL type of each uniform. */
    val types: Map<String, Int> = frames.flatten().firstOrNull()?.uniforms.orEmpty().mapValues { it.value.type }

    /** Names of the uniforms of [type]. */
    fun names(type: Int): List<String> = types.filterValues { it == type }.keys.toList()

    /** The matrices that every draw has. */
    val matrices: List<String> get() = names(GL_FLOAT_MAT4)

    /** What [name] was in the last draw of each frame. */
    fun vectors(name: String): List<Vector3d> = frames.map { it.last().vector(name) }
}

/** The numbers of one draw. */
internal class Sending(
    val draw: CapturedDraw,
) {
    val uniforms: Map<String, UniformValue> = draw.uniforms.associateBy { it.name }

    /** What is drawn: the same in every frame. */
    val mesh: List<Any?> = draw.attributes.map { it.buffer } + draw.indices + draw.first

    fun numbers(name: String): FloatArray = uniforms[name]?.numbers ?: FloatArray(FULL)

    fun matrix(name: String): Matrix4d = Matrix4d().set(DoubleArray(FULL) { numbers(name).getOrElse(it) { 0f }.toDouble() })

    fun vector(name: String): Vector3d = numbers(name).let { n -> Vector3d(DoubleArray(3) { n.getOrElse(it) { 0f }.toDouble() }) }

    private companion object {
        const val FULL = 16
    }
}
