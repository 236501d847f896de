package cga.grading.worker

import cga.grading.capture.DrawState
import cga.grading.capture.WriteMask
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/** The fixed-function state of now. */
internal object State {
    fun read(): DrawState =
        DrawState(
            viewport = integers(GL_VIEWPORT, BOX),
            depthTest = glIsEnabled(GL_DEPTH_TEST),
            depthFunc = glGetInteger(GL_DEPTH_FUNC),
            depthMask = glGetBoolean(GL_DEPTH_WRITEMASK),
            cullFace = glIsEnabled(GL_CULL_FACE),
            cullMode = glGetInteger(GL_CULL_FACE_MODE),
            frontFace = glGetInteger(GL_FRONT_FACE),
            blend = glIsEnabled(GL_BLEND),
            blendSource = glGetInteger(GL_BLEND_SRC_RGB),
            blendDestination = glGetInteger(GL_BLEND_DST_RGB),
            polygonMode = integers(GL_POLYGON_MODE, BOTH_SIDES)[0],
            framebufferSrgb = glIsEnabled(GL_FRAMEBUFFER_SRGB),
            writes = writes(),
        )

    /** What of the state changes the picture and has no place in a [DrawState]; null for nothing. */
    fun unusual(): String? =
        SWITCHES.firstNotNullOfOrNull { (switch, name) -> name.takeIf { glIsEnabled(switch) } }
            ?: when {
                !glIsEnabled(GL_MULTISAMPLE) -> "GL_MULTISAMPLE off"
                glIsEnabled(GL_BLEND) && hasUnusualBlending() -> "glBlendEquation, glBlendFuncSeparate or glBlendColor"
                else -> null
            }

    /** What may be written of the framebuffer. */
    fun writes(): WriteMask =
        MemoryStack.stackPush().use { stack ->
            val mask = stack.malloc(4)
            glGetBooleanv(GL_COLOR_WRITEMASK, mask)
            val channels = (0 until 4).sumOf { if (mask[it] == 0.toByte()) 0 else 1 shl it }
            WriteMask(if (glIsEnabled(GL_SCISSOR_TEST)) integers(GL_SCISSOR_BOX, BOX) else null, channels)
        }

    private fun hasUnusualBlending() =
        glGetInteger(GL_BLEND_EQUATION_RGB) != GL_FUNC_ADD || glGetInteger(GL_BLEND_EQUATION_ALPHA) != GL_FUNC_ADD ||
            glGetInteger(GL_BLEND_SRC_ALPHA) != glGetInteger(GL_BLEND_SRC_RGB) ||
            glGetInteger(GL_BLEND_DST_ALPHA) != glGetInteger(GL_BLEND_DST_RGB) ||
            listOf(glGetInteger(GL_BLEND_SRC_RGB), glGetInteger(GL_BLEND_DST_RGB)).any { it >= GL_CONSTANT_COLOR }

    private fun integers(
        name: Int,
        count: Int,
    ): List<Int> =
        MemoryStack.stackPush().use { stack ->
            val integers = stack.mallocInt(count)
            glGetIntegerv(name, integers)
            List(count) { integers[it] }
        }

    private const val BOX = 4

    /** Drivers answer with one mode for each side, whatever OpenGL 3.3 says. */
    private const val BOTH_SIDES = 2

    private val SWITCHES =
        mapOf(
            GL_STENCIL_TEST to "GL_STENCIL_TEST",
            GL_POLYGON_OFFSET_FILL to "GL_POLYGON_OFFSET_FILL",
            GL_POLYGON_OFFSET_LINE to "GL_POLYGON_OFFSET_LINE",
            GL_DEPTH_CLAMP to "GL_DEPTH_CLAMP",
            GL_COLOR_LOGIC_OP to "GL_COLOR_LOGIC_OP",
            GL_SAMPLE_ALPHA_TO_COVERAGE to "GL_SAMPLE_ALPHA_TO_COVERAGE",
            GL_SAMPLE_ALPHA_TO_ONE to "GL_SAMPLE_ALPHA_TO_ONE",
            GL_SAMPLE_COVERAGE to "GL_SAMPLE_COVERAGE",
            GL_SAMPLE_MASK to "GL_SAMPLE_MASK",
            GL_PRIMITIVE_RESTART to "GL_PRIMITIVE_RESTART",
            GL_RASTERIZER_DISCARD to "GL_RASTERIZER_DISCARD",
            GL_PROGRAM_POINT_SIZE to "GL_PROGRAM_POINT_SIZE",
        )
}
