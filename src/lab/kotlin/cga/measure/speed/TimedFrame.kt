package cga.measure.speed

/** A frame that can be drawn again and again, in the context that is current. */
internal abstract class TimedFrame : AutoCloseable {
    /** From the first matrix to the last pixel. */
    abstract fun draw()

    /** Times [count] frames. */
    fun time(count: Int): FrameTimes = FrameTimes.measure(count) { draw() }

    /** Times [count] frames of a driver that does nothing. */
    fun timeWithoutDriver(count: Int): FrameTimes {
        // What is uploaded and compiled at first takes a driver.
        draw()
        return NullDriver.use { time(count) }
    }
}
