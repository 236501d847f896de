package cga.grading.worker

import cga.grading.capture.Cursor
import org.lwjgl.glfw.GLFW.*

/**
 * Callbacks that a submission has set on the [window] itself. There, as in the course's own window, they take the place of `onKey` and
 * `onMouseMove`; nothing else happens in the script that GLFW would call back for.
 */
internal class OwnCallbacks(private val window: Long) {
    /** Tells the submission's callback of a key, and whether there is one. */
    fun key(act: Act.Press): Boolean {
        // GLFW tells only whoever sets another.
        val own = glfwSetKeyCallback(window, null) ?: return false
        glfwSetKeyCallback(window, own)
        val action = if (act.isDown) GLFW_PRESS else GLFW_RELEASE
        own.invoke(window, act.key, glfwGetKeyScancode(act.key), action, act.modifiers)
        return true
    }

    /** Likewise of where the [cursor] is. */
    fun move(cursor: Cursor): Boolean {
        val own = glfwSetCursorPosCallback(window, null) ?: return false
        glfwSetCursorPosCallback(window, own)
        own.invoke(window, cursor.x, cursor.y)
        return true
    }
}
