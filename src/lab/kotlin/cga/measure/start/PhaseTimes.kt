package cga.measure.start

import cga.framework.InputError
import cga.framework.Phases
import java.nio.file.Path
import kotlin.io.path.readLines

/** One span of a process, as [Phases] wrote it: milliseconds since the process was started. */
internal data class PhaseTime(
    val name: String,
    val start: Double,
    val end: Double,
) {
    val milliseconds: Double get() = end - start
}

/** Where the time of a process went. */
internal object PhaseTimes {
    /** The spans in [file], of a process that was started at [started], microseconds since 1970. */
    fun read(
        file: Path,
        started: Long,
    ): List<PhaseTime> =
        file.readLines().map { line ->
            val words = line.split(' ')
            val (start, end) = words.drop(1).mapNotNull { it.toLongOrNull() }.takeIf { words.size == 3 && it.size == 2 }
                ?: throw InputError("$file holds '$line', which is no phase.")
            PhaseTime(words[0], (start - started) / 1e3, (end - started) / 1e3)
        }

    /** The milliseconds of each name, those of one name added up, in the order in which they first began. */
    fun byName(phases: List<PhaseTime>): Map<String, Double> =
        phases.sortedBy { it.start }.groupBy { it.name }.mapValues { (_, spans) -> spans.sumOf { it.milliseconds } }
}
