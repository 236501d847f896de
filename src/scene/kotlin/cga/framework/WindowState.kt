package cga.framework

/**
 * What a scene asks of the window that it lives in: the size of its picture and the keys held down.
 *
 * [GameWindow] answers from the real window; off screen a script answers, so that input is an argument and never a device.
 */
public interface WindowState {
    /** Width of the picture in pixels; on high-resolution displays more than the window's width. */
    public val framebufferWidth: Int

    /** Height of the picture in pixels. */
    public val framebufferHeight: Int

    /** Whether [key] (a `GLFW_KEY_…` constant) is held down. */
    public fun getKeyState(key: Int): Boolean
}
