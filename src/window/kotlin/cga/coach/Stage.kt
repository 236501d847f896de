package cga.coach

/**
 * What the course's `GameWindow` stands on: the window, and whatever looks at the program that plays in it.
 *
 * @param width of the window in screen coordinates, likewise [height].
 * @param major version of OpenGL, with [minor]; core profile.
 * @param samples a pixel, 0 for none.
 * @param updateFrequency updates a second.
 */
public class Stage(
    public val width: Int,
    public val height: Int,
    public val fullscreen: Boolean,
    public val vsync: Boolean,
    public val major: Int,
    public val minor: Int,
    public val title: String,
    public val samples: Int,
    public val updateFrequency: Float,
) {
    private val host = Tools.host

    init {
        host.open(this)
    }

    /** GLFW's handle of the window. */
    public val window: Long get() = host.window
    public val framebufferWidth: Int get() = host.framebufferWidth
    public val framebufferHeight: Int get() = host.framebufferHeight

    /** Time of the last update, in seconds. */
    public val time: Double get() = host.time
    public val mouseX: Double get() = host.mouseX
    public val mouseY: Double get() = host.mouseY

    /** Plays [program] until the window is closed. */
    public fun run(program: Program): Unit = host.run(program)

    /** Whether [key] (GLFW's constant) is held down. */
    public fun isDown(key: Int): Boolean = host.isDown(key)

    public fun setCursorVisible(visible: Boolean): Unit = host.setCursorVisible(visible)

    public fun setTitle(text: String): Unit = host.setTitle(text)

    /** Closes the window after the present picture. */
    public fun quit(): Unit = host.quit()
}
