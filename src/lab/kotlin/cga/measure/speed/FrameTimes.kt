package cga.measure.speed

import cga.measure.Sample
import com.sun.management.ThreadMXBean
import java.lang.management.ManagementFactory

/** What frames took, one number a frame: milliseconds by the clock and of the drawing thread's processor, and bytes of the JVM's heap. */
internal class FrameTimes(
    val clock: DoubleArray,
    val thread: DoubleArray,
    val bytes: DoubleArray,
) {
    /** One line, for another process. */
    override fun toString(): String = listOf(clock, thread, bytes).joinToString(";") { it.joinToString(",") }

    companion object {
        private val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean

        /** Draws [count] frames. */
        inline fun measure(
            count: Int,
            draw: () -> Unit,
        ): FrameTimes {
            val times = FrameTimes(DoubleArray(count), DoubleArray(count), DoubleArray(count))
            for (frame in 0 until count) {
                val bytes = allocated()
                val thread = processorTime()
                val start = System.nanoTime()
                draw()
                times.clock[frame] = (System.nanoTime() - start) / 1e6
                times.thread[frame] = (processorTime() - thread) / 1e6
                times.bytes[frame] = (allocated() - bytes).toDouble()
            }
            return times
        }

        /** What [toString] wrote. */
        fun parse(line: String): FrameTimes {
            val (clock, thread, bytes) = line.split(';').map { numbers -> numbers.split(',').map { it.toDouble() }.toDoubleArray() }
            return FrameTimes(clock, thread, bytes)
        }

        fun allocated(): Long = threads.currentThreadAllocatedBytes

        fun processorTime(): Long = threads.currentThreadCpuTime
    }
}

/** The median of [values]. */
internal fun median(values: DoubleArray): Double = Sample(values.asList()).median
