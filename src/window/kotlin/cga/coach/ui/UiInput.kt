package cga.coach.ui

import org.lwjgl.glfw.GLFW.*
import org.lwjgl.nuklear.NkContext
import org.lwjgl.nuklear.NkVec2
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.system.MemoryStack

/** Hands GLFW's events to the panels, with GLFW's constants and in window units. */
internal class UiInput(private val context: NkContext) {
    private var x = 0
    private var y = 0

    fun move(
        xpos: Double,
        ypos: Double,
    ) {
        x = xpos.toInt()
        y = ypos.toInt()
        nk_input_motion(context, x, y)
    }

    fun button(
        button: Int,
        action: Int,
    ) {
        val which =
            when (button) {
                GLFW_MOUSE_BUTTON_LEFT -> NK_BUTTON_LEFT
                GLFW_MOUSE_BUTTON_RIGHT -> NK_BUTTON_RIGHT
                else -> return
            }
        nk_input_button(context, which, x, y, action == GLFW_PRESS)
    }

    fun scroll(
        dx: Double,
        dy: Double,
    ) {
        MemoryStack.stackPush().use { stack -> nk_input_scroll(context, NkVec2.malloc(stack).set(dx.toFloat(), dy.toFloat())) }
    }

    fun character(codePoint: Int) {
        nk_input_unicode(context, codePoint)
    }

    /** Keys that edit text; others are none of the panels' business. */
    fun key(
        key: Int,
        action: Int,
    ) {
        val which = EDITING[key] ?: return
        nk_input_key(context, which, action != GLFW_RELEASE)
    }

    private companion object {
        val EDITING =
            mapOf(
                GLFW_KEY_BACKSPACE to NK_KEY_BACKSPACE,
                GLFW_KEY_DELETE to NK_KEY_DEL,
                GLFW_KEY_ENTER to NK_KEY_ENTER,
                GLFW_KEY_KP_ENTER to NK_KEY_ENTER,
                GLFW_KEY_LEFT to NK_KEY_LEFT,
                GLFW_KEY_RIGHT to NK_KEY_RIGHT,
                GLFW_KEY_HOME to NK_KEY_TEXT_LINE_START,
                GLFW_KEY_END to NK_KEY_TEXT_LINE_END,
            )
    }
}
