package cga.cli.lab

import cga.cli.contextOption
import cga.framework.Display
import cga.framework.InputError
import cga.inspect.soak.Flatness
import cga.inspect.soak.Held
import cga.inspect.soak.WindowSoak
import cga.measure.accuracy.hard.HardCases
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.long
import com.github.ajalt.clikt.parameters.types.restrictTo

/** `cga soak`: the long form of the search that the tests do shortly. */
internal class SoakCommand : CliktCommand("soak") {
    override fun help(context: Context): String =
        "Shade random points, many at the limits of the domain, and look for NaN, Inf and errors that rounding does not explain. " +
            "With --window: use the window for minutes, and look whether its memory and its OpenGL objects grow. " +
            "Exit code 1: one was found."

    private val evaluations by option("--evaluations", metavar = "N", help = "Points to shade. Default: 1000000")
        .int()
        .restrictTo(min = 1)
        .default(1_000_000)
    private val seed by option("--seed", metavar = "N", help = "The same seed gives the same points. Default: 1").long().default(1)
    private val context by contextOption()

    private val window by option("--window", metavar = "MINUTES", help = "Use the window for so long instead")
        .double()
        .restrictTo(min = 0.1, max = 600.0)

    override fun run() {
        window?.let { soakWindow(it) } ?: soakShading()
    }

    private fun soakWindow(minutes: Double) {
        if (!Display.isPresent) {
            throw InputError("there is no display to open a window on: start it in a desktop session, or under xvfb-run.")
        }
        val seconds = minutes * SECONDS
        val soak = WindowSoak(WIDTH, HEIGHT, seconds, seconds / LOOKS) { echo(line(it)) }
        soak.run()
        Flatness.slopes(soak.looks).forEach(::echo)
        val growth = Flatness.growth(soak.looks)
        growth.forEach(::echo)
        if (growth.isNotEmpty()) throw ProgramResult(FOUND)
        echo("flat: nothing grew")
    }

    private fun line(held: Held) =
        "%6.0f s  %7d pictures  %6.0f MiB resident  %6.1f MiB live heap  %5d OpenGL objects".format(
            held.seconds,
            held.pictures,
            held.resident,
            held.live,
            held.glObjects,
        )

    private fun soakShading() {
        val result = HardCases.search(evaluations, seed, context)
        echo("${result.evaluations} points shaded, ${result.notFinite} of them not finite")
        echo("${result.compared} compared with the truth, ${result.beyondBound} beyond their bound; worst: ${result.worst} of its bound")
        result.findings.forEach(::echo)
        if (result.notFinite + result.beyondBound > 0) throw ProgramResult(FOUND)
    }

    private companion object {
        const val FOUND = 1
        const val SECONDS = 60
        const val LOOKS = 40
        const val WIDTH = 960
        const val HEIGHT = 540
    }
}
