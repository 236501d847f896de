package cga.framework

import java.nio.file.Path
import java.time.Instant
import java.time.temporal.ChronoUnit.MICROS
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.io.path.writeLines

/**
 * Where the time of a process goes, for those who measure it from outside: named spans of the wall clock.
 *
 * Off, and then free, unless the system property `cga.phases` names the file that [save] writes: a line `NAME START END` each, in
 * microseconds since 1970, in the order in which they ended. Spans of several threads may overlap.
 */
public object Phases {
    private val file: String? = System.getProperty("cga.phases")
    private val spans = ConcurrentLinkedQueue<String>()

    /** Answers what [work] does, and remembers when it ran as [name] (no spaces). */
    public fun <T> span(name: String, work: () -> T): T {
        if (file == null) return work()
        val start = now()
        try {
            return work()
        } finally {
            spans += "$name $start ${now()}"
        }
    }

    /** Writes what was remembered. */
    public fun save() {
        if (file != null) Path.of(file).writeLines(spans)
    }

    private fun now(): Long = MICROS.between(Instant.EPOCH, Instant.now())
}
