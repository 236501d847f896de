package cga.cli

import cga.measure.accuracy.hard.HardCases
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.long
import com.github.ajalt.clikt.parameters.types.restrictTo

/** `cga soak`: the long form of the search that the tests do shortly. */
internal class SoakCommand : CliktCommand("soak") {
    override fun help(context: Context): String =
        "Shade random points, many at the limits of the domain, and look for NaN, Inf and errors that rounding does not explain. " +
            "Exit code 1: one was found."

    private val evaluations by option("--evaluations", metavar = "N", help = "Points to shade. Default: 1000000")
        .int()
        .restrictTo(min = 1)
        .default(1_000_000)
    private val seed by option("--seed", metavar = "N", help = "The same seed gives the same points. Default: 1").long().default(1)
    private val context by contextOption()

    override fun run() {
        val result = HardCases.search(evaluations, seed, context)
        echo("${result.evaluations} points shaded, ${result.notFinite} of them not finite")
        echo("${result.compared} compared with the truth, ${result.beyondBound} beyond their bound; worst: ${result.worst} of its bound")
        result.findings.forEach(::echo)
        if (result.notFinite + result.beyondBound > 0) throw ProgramResult(FOUND)
    }

    private companion object {
        const val FOUND = 1
    }
}
