package cga.framework.context

import cga.framework.Display
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.system.MemoryUtil.NULL

/** A window of the desktop that is never shown, for its context. */
internal class HiddenWindowContext : OffscreenContext {
    override val kind: ContextKind = ContextKind.WINDOW
    private val window: Long

    init {
        val reason = if (Display.isPresent) Glfw.start(GLFW_ANY_PLATFORM) else "neither DISPLAY nor WAYLAND_DISPLAY is set"
        if (reason != null) throw ContextUnavailable("window: no display ($reason). Start it in a desktop session, or under xvfb-run.")
        Glfw.hintCoreProfile()
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE)
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE)
        window =
            Glfw.openWindow(1, 1, "", NULL) { refusal ->
                ContextUnavailable("window: $refusal. Install the driver (Debian or Ubuntu: apt-get install libgl1 libgl1-mesa-dri).")
            }
    }

    override fun close(): Unit = Glfw.stop(window)
}
