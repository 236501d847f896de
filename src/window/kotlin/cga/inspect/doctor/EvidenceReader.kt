package cga.inspect.doctor

import cga.exercise.game.Scene
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.FloatImage
import cga.inspect.view.Look
import cga.inspect.view.Traffic
import cga.inspect.view.View
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/**
 * Looks at a [scene] that draws with [cga.inspect.view.InspectedProgram]s which obey [look] and report to [traffic].
 * Needs the OpenGL context; leaves the window's framebuffer bound.
 */
internal class EvidenceReader(
    private val scene: Scene,
    private val look: Look,
    private val traffic: Traffic,
) {
    /** Draws the scene small, twice, and reads everything that a cause may be found in. Throws what drawing throws. */
    fun read(): Evidence =
        RenderTarget(WIDTH, HEIGHT, 0, ColorFormat.RGBA32F)
            .use { target ->
                val view = look.view
                look.view = View.EMISSION
                traffic.sent.clear()
                traffic.isRecorded = true
                try {
                    val withoutLights = draw(target)
                    look.view = View.FULL
                    val picture = draw(target)
                    val program = glGetInteger(GL_CURRENT_PROGRAM)
                    val uniforms = if (program == 0) emptyList() else uniforms(program)
                    val (read, plain) = uniforms.partition { it.type == GL_SAMPLER_2D }
                    val samplers = read.map { sampler(it.name, it.numbers[0].toInt()) }
                    val (sent, warnings) = traffic.sent.toSet() to traffic.warnings.toList()
                    Evidence(program, plain, samplers, sent, warnings, scene.frame(), picture, withoutLights)
                } finally {
                    traffic.isRecorded = false
                    look.view = view
                }
            }.also { glBindFramebuffer(GL_FRAMEBUFFER, 0) }

    private fun draw(target: RenderTarget): FloatImage {
        // What others left in use is not the scene's merit.
        glUseProgram(0)
        target.bind()
        scene.render()
        // A scene that draws without a program makes errors, which are evidence and nobody else's.
        generateSequence(::glGetError).take(MAX_ERRORS).takeWhile { it != GL_NO_ERROR }.count()
        return target.readFloats()
    }

    private fun uniforms(program: Int): List<UniformValue> =
        MemoryStack.stackPush().use { stack ->
            val size = stack.mallocInt(1)
            val type = stack.mallocInt(1)
            val floats = stack.mallocFloat(16)
            val ints = stack.mallocInt(4)
            List(glGetProgrami(program, GL_ACTIVE_UNIFORMS)) { i ->
                val name = glGetActiveUniform(program, i, size, type)
                val location = glGetUniformLocation(program, name)
                val count = SIZES[type[0]]
                if (count != null) {
                    glGetUniformfv(program, location, floats)
                    UniformValue(name, type[0], FloatArray(count) { floats[it] })
                } else {
                    glGetUniformiv(program, location, ints)
                    UniformValue(name, type[0], floatArrayOf(ints[0].toFloat()))
                }
            }
        }

    private fun sampler(
        name: String,
        unit: Int,
    ): SamplerState {
        glActiveTexture(GL_TEXTURE0 + unit)
        val hasTexture = glGetInteger(GL_TEXTURE_BINDING_2D) != 0
        val width = glGetTexLevelParameteri(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH)
        val usesMipmaps = glGetTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER).let { it != GL_NEAREST && it != GL_LINEAR }
        val levels = glGetTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL)
        val hasMipmaps = width == 1 || levels == 0 || glGetTexLevelParameteri(GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH) > 0
        val problem =
            when {
                !hasTexture -> "no texture is bound to unit $unit"
                width == 0 -> "the texture at unit $unit has no picture"
                usesMipmaps && !hasMipmaps -> "the texture at unit $unit is filtered with mipmaps and has none"
                else -> null
            }
        return SamplerState(name, unit, problem)
    }

    private companion object {
        const val WIDTH = 160
        const val HEIGHT = 90
        const val MAX_ERRORS = 1000

        /** Numbers of the types that are read as floats. */
        val SIZES =
            mapOf(
                GL_FLOAT to 1,
                GL_FLOAT_VEC2 to 2,
                GL_FLOAT_VEC3 to 3,
                GL_FLOAT_VEC4 to 4,
                GL_FLOAT_MAT3 to 9,
                GL_FLOAT_MAT4 to 16,
            )
    }
}
