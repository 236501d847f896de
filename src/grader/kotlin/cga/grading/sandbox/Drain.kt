package cga.grading.sandbox

import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.InputStream
import kotlin.concurrent.thread

/** Reads [stream] to its end, so that nobody waits for a full pipe, and keeps the first [kept] bytes. */
internal class Drain(
    private val stream: InputStream,
    private val kept: Int,
) {
    private val head = ByteArrayOutputStream()
    private val worker = thread(isDaemon = true, name = "drain", block = ::read)

    /** Bytes that have come so far. */
    @Volatile
    var total: Long = 0
        private set

    private fun read() {
        val buffer = ByteArray(BUFFER)
        try {
            while (true) {
                val count = stream.read(buffer)
                if (count < 0) return
                synchronized(head) { head.write(buffer, 0, minOf(count, kept - head.size())) }
                total += count
            }
        } catch (_: IOException) {
            // Closed by us, because somebody who outlived the job still held its other end.
        }
    }

    /** What was kept. Waits for the end of the stream, but not for long. */
    fun finish(): String {
        worker.join(PATIENCE)
        if (worker.isAlive) stream.close()
        return synchronized(head) { head.toString(Charsets.UTF_8) }
    }

    private companion object {
        const val BUFFER = 1 shl 16
        const val PATIENCE = 2000L
    }
}
