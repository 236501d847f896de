package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.EventKind
import cga.grading.capture.GlNumbers
import cga.grading.capture.UniformValue
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/** An active uniform, or one element of one that is an array. */
internal class Uniform(
    val name: String,
    val type: Int,
    val location: Int,
)

/** Reads which uniforms a program has and what they hold. */
internal object Uniforms {
    /** The uniforms of the linked [program], arrays written out; those that a capture cannot hold are noted on [tape]. */
    fun of(
        program: Int,
        tape: Tape,
    ): List<Uniform> =
        MemoryStack.stackPush().use { stack ->
            val size = stack.mallocInt(1)
            val type = stack.mallocInt(1)
            (0 until glGetProgrami(program, GL_ACTIVE_UNIFORMS)).flatMap { index ->
                val name = glGetActiveUniform(program, index, size, type)
                val names = elements(name, size[0])
                val kind = type[0]
                when {
                    glGetUniformLocation(program, name) < 0 -> emptyList()
                    GlNumbers.components(kind) == null || name.length > CaptureLimits.NAME ->
                        emptyList<Uniform>().also { tape.event(EventKind.NOT_CAPTURED, "the uniform ${name.take(CaptureLimits.NAME)}") }
                    else -> names.map { Uniform(it, kind, glGetUniformLocation(program, it)) }.filter { it.location >= 0 }
                }
            }
        }

    /** The names of all [size] elements of an array that OpenGL calls [name]; of what is no array its own. */
    fun elements(
        name: String,
        size: Int,
    ): List<String> = if (name.endsWith("[0]")) List(size) { "${name.dropLast(ZERO)}[$it]" } else listOf(name)

    /** What [uniform] of [program] holds now, which [caller] sent. */
    fun value(
        program: Int,
        uniform: Uniform,
        caller: Int = -1,
    ): UniformValue =
        MemoryStack.stackPush().use { stack ->
            val size = GlNumbers.components(uniform.type) ?: 0
            val numbers =
                when {
                    GlNumbers.isWhole(uniform.type) -> {
                        val whole = stack.mallocInt(size)
                        glGetUniformiv(program, uniform.location, whole)
                        FloatArray(size) { whole[it].toFloat() }
                    }
                    GlNumbers.isUnsigned(uniform.type) -> {
                        val whole = stack.mallocInt(size)
                        glGetUniformuiv(program, uniform.location, whole)
                        FloatArray(size) { whole[it].toUInt().toFloat() }
                    }
                    else -> {
                        val real = stack.mallocFloat(size)
                        glGetUniformfv(program, uniform.location, real)
                        FloatArray(size) { real[it] }
                    }
                }
            UniformValue(uniform.name, uniform.type, numbers, caller)
        }

    private const val ZERO = "[0]".length
}
