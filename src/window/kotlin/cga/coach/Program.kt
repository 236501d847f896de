package cga.coach

/** A program with a game loop, as the window sees it. All times are in seconds; keys, actions and modifiers are GLFW's constants. */
public interface Program {
    /** Called once, with an OpenGL context, before anything else. */
    public fun start()

    /** Advances by [dt] to the time [t]. */
    public fun update(
        dt: Float,
        t: Float,
    )

    /** Draws the picture of the time [t] into the framebuffer that is bound; [dt] is the time since the last one. */
    public fun render(
        dt: Float,
        t: Float,
    )

    public fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    )

    public fun onMouseMove(
        xpos: Double,
        ypos: Double,
    )

    public fun onMouseButton(
        button: Int,
        action: Int,
        mode: Int,
    )

    public fun onMouseScroll(
        xoffset: Double,
        yoffset: Double,
    )

    /** Called once, at the end. */
    public fun shutdown()
}
