package cga.coach

/** The window and its tools. There is one in a process, whatever number of programs play in it one after the other. */
public interface Host {
    /** GLFW's handle of the window. */
    public val window: Long
    public val framebufferWidth: Int
    public val framebufferHeight: Int

    /** Time of the last update, in seconds. */
    public val time: Double
    public val mouseX: Double
    public val mouseY: Double

    /** Opens the window that [stage] asks for, unless it is open. */
    public fun open(stage: Stage)

    /** Plays [program] until the window is closed. Where another plays already, [program] is to take its place: then this returns at once. */
    public fun run(program: Program)

    /** Plays what a compiler that watches the sources makes of them: see `cga.coach.build`. */
    public fun runBuilt()

    /** Whether [key] is held down. */
    public fun isDown(key: Int): Boolean

    public fun setCursorVisible(visible: Boolean)

    public fun setTitle(text: String)

    public fun quit()
}
