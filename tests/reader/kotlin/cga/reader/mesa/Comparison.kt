package cga.reader.mesa

import cga.reader.run.Outcome
import cga.reader.tape.RunningError
import cga.reader.tape.Tape
import kotlin.math.abs

/** How far the driver is from the reader, number by number, as shares of what floats may be off. */
internal class Comparison {
    var numbers = 0
        private set

    /** Where a comparison could go either way, or no bound is known. */
    var open = 0
        private set
    var largest = 0.0
        private set
    val wrong = ArrayList<String>()

    /** Adds the numbers that the driver has for the output [name], or null where it discarded, where the reader has [read], on [tape]. */
    fun add(what: String, read: DoubleArray, tape: Tape, outcome: Outcome, name: String, drawn: DoubleArray?) {
        val error = RunningError(tape)
        if (!error.isDecided) {
            open++
            return
        }
        if ((outcome == Outcome.DISCARDED) != (drawn == null)) wrong += "$what: the reader is $outcome, the driver ${drawn?.asList()}"
        if (drawn == null || outcome != Outcome.DONE) return
        val references = tape.references(name)
        for (i in drawn.indices) {
            val bound = error.of(references[i])
            if (!bound.isFinite()) {
                open++
                continue
            }
            numbers++
            val ratio = abs(drawn[i] - read[i]) / (bound + 1e-37)
            if (!(ratio <= 1)) {
                wrong +=
                    "$what: $name[$i] is ${drawn[i]}, read ${read[i]}, off by ${abs(drawn[i] - read[i])}, at most $bound"
            }
            if (ratio > largest) largest = ratio
        }
    }

    operator fun plusAssign(other: Comparison) {
        numbers += other.numbers
        open += other.open
        largest = maxOf(largest, other.largest)
        wrong += other.wrong
    }

    override fun toString() = "%d numbers, %d open, largest error/bound %.3f, %d wrong".format(numbers, open, largest, wrong.size)
}
