package cga.grading.worker

/**
 * What a submission is answered that asks for the time or for keys by itself, past its window: the script's. [Rerouting] takes its calls
 * here; the names are those of the methods that they were meant for.
 */
public object ScriptedCalls {
    /** Seconds of the script, and what is held down; the window's stage sets them. */
    @Volatile
    internal var time: () -> Double = { 0.0 }

    @Volatile
    internal var isHeld: (Int) -> Boolean = { false }
    private val start = System.currentTimeMillis()

    /** Each question takes a little time, so that whoever waits for a later hour does not wait for ever. */
    private var asked = 0L

    /** In the place of GLFW's: 1 for a key that is held down, else 0. */
    @JvmStatic
    @Suppress("UNUSED_PARAMETER")
    public fun glfwGetKey(
        window: Long,
        key: Int,
    ): Int = if (isHeld(key)) 1 else 0

    /** In the place of GLFW's: seconds. */
    @JvmStatic
    public fun glfwGetTime(): Double = nanoTime() * 1e-9

    /** In the place of Java's, likewise [currentTimeMillis]. */
    @JvmStatic
    public fun nanoTime(): Long = (time() * SECOND).toLong() + STEP * synchronized(this) { ++asked }

    @JvmStatic
    public fun currentTimeMillis(): Long = start + nanoTime() / MILLISECOND

    private const val SECOND = 1e9
    private const val MILLISECOND = 1_000_000L

    /** Nanoseconds. */
    private const val STEP = 1000L
}
