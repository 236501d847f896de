package cga.inspect.soak

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readLines

/**
 * What was held at a moment of a soak.
 *
 * @param seconds since the soak began, its warm-up left out.
 * @param resident MiB of memory, of the whole process.
 * @param live MiB of the heap that are in use after a collection.
 */
public class Held(
    public val seconds: Double,
    public val pictures: Int,
    public val resident: Double,
    public val live: Double,
    public val glObjects: Int,
) {
    internal companion object {
        private const val KIB = 1024.0

        /** What is held now. Takes some tens of milliseconds. Needs the OpenGL context. */
        fun now(
            seconds: Double,
            pictures: Int,
        ): Held {
            System.gc()
            val live = Runtime.getRuntime().run { totalMemory() - freeMemory() } / (KIB * KIB)
            return Held(seconds, pictures, resident() ?: live, live, GlObjects.count())
        }

        // The operating system's own figure, where it has one.
        private fun resident(): Double? {
            val status = Path.of("/proc/self/status")
            val line = if (status.exists()) status.readLines().find { it.startsWith("VmRSS:") } else null
            return line?.filter(Char::isDigit)?.toDouble()?.div(KIB)
        }
    }
}
