package cga.framework

import org.lwjgl.glfw.GLFW.*

/**
 * The cursor of a [window] as [position] has it: where it is seen, or, hidden, how far a hand has moved it. Hidden it is captured, and
 * moves without end.
 *
 * GLFW puts a hidden cursor back into the window's middle whenever the window gets the keyboard, and may tell so as a movement. So what it
 * tells then is passed over until the window system has said all that it has to say.
 *
 * @param scale so many of GLFW's units are one of [position]'s.
 * @param moved is called when [position] is new.
 */
internal class WindowCursor(
    private val window: Long,
    private val scale: Int,
    private val position: MousePosition,
    private val moved: () -> Unit,
) {
    private val x = DoubleArray(1)
    private val y = DoubleArray(1)
    private var originX = 0.0
    private var originY = 0.0
    private var isSettling = false
    private var nextLook = 0.0

    var isVisible: Boolean
        get() = glfwGetInputMode(window, GLFW_CURSOR) == GLFW_CURSOR_NORMAL
        set(value) {
            glfwSetInputMode(window, GLFW_CURSOR, if (value) GLFW_CURSOR_NORMAL else GLFW_CURSOR_DISABLED)
            isSettling = true
        }

    init {
        glfwSetWindowFocusCallback(window) { _, _ -> isSettling = true }
        glfwSetCursorEnterCallback(window) { _, _ -> isSettling = true }
        glfwSetCursorPosCallback(window) { _, xpos, ypos -> move(xpos, ypos) }
    }

    /** To be called when the events of a picture have come in, [now] (seconds). */
    fun hold(now: Double) {
        if (now >= nextLook) {
            nextLook = now + PAUSE
            if (hasEscaped()) capture()
        }
        if (isSettling) settle()
    }

    private fun move(
        xpos: Double,
        ypos: Double,
    ) {
        if (isVisible) {
            originX = 0.0
            originY = 0.0
        } else if (isSettling) {
            return
        }
        position.xpos = originX + xpos / scale
        position.ypos = originY + ypos / scale
        moved()
    }

    // A window that is just being moved, as when it is restored with an animation, cannot capture it, and GLFW does not try again.
    private fun hasEscaped() = !isVisible && has(GLFW_FOCUSED) && !has(GLFW_ICONIFIED) && !has(GLFW_HOVERED)

    private fun capture() {
        isVisible = true
        isVisible = false
    }

    private fun settle() {
        // The window system's answer comes after all that it has told before.
        has(GLFW_FOCUSED)
        glfwPollEvents()
        isSettling = false
        glfwGetCursorPos(window, x, y)
        // GLFW puts a cursor that is shown again back to where it was hidden, and does not tell.
        if (isVisible) return move(x[0], y[0])
        originX = position.xpos - x[0] / scale
        originY = position.ypos - y[0] / scale
        moved()
    }

    private fun has(attribute: Int) = glfwGetWindowAttrib(window, attribute) == GLFW_TRUE

    private companion object {
        /** Seconds. */
        const val PAUSE = 0.1
    }
}
