package cga.cli

import cga.framework.AtomicFile
import cga.framework.image.PngFile
import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.Picture
import cga.imaging.PictureFile
import cga.imaging.Pixel
import cga.imaging.Severity
import cga.imaging.figures
import cga.imaging.tolerance.Tolerance
import cga.imaging.values
import cga.imaging.written
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import com.github.ajalt.mordant.rendering.Whitespace
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.table
import java.nio.file.Files
import java.nio.file.Path

/** `cga diff`: how two pictures differ. It ends with 0 where that is allowed, with 1 where it is not. */
internal class DiffCommand : CliktCommand("diff") {
    override fun help(context: Context): String =
        "Compare two pictures, PNG or OpenEXR. Exit code 0: equal, or within the tolerance; 1: different; 2: they cannot be compared."

    private val expected by argument("EXPECTED", help = "The picture as it should be").path()
    private val actual by argument("ACTUAL", help = "The picture as it is").path()
    private val map by option(
        "--map",
        metavar = "FILE.png",
        help = "Where they differ to the eye: the ꟻLIP map, black to pale yellow",
    ).path()
    private val tolerance by option("--tolerance", metavar = "FILE.json", help = "What may differ. Default: nothing").path()
    private val tier by option("--tier", metavar = "NAME", help = "The tolerance of this name, where the file holds several")

    override fun run() {
        requireUsage(tier == null || tolerance != null) { "--tier $tier: name the file with --tolerance" }
        map?.let(::checkMap)
        val allowed = tolerance?.let { Tolerance.read(it, tier) }
        val comparison = Comparison(PictureFile.read(expected), PictureFile.read(actual))
        if (comparison.isIdentical) echo("identical: ${comparison.expected.description()}") else print(comparison)
        map?.let { PngFile.write(comparison.flip.magma(), it) }
        if (!isAllowed(comparison, allowed)) throw ProgramResult(DIFFERENT)
    }

    /** A slip of the hand must not cost a picture. */
    private fun checkMap(map: Path) {
        requireEnding("--map", map, ".png")
        AtomicFile.checkWritable(map)
        val input = listOf(expected, actual).find { Files.exists(map) && Files.exists(it) && Files.isSameFile(map, it) }
        requireUsage(input == null) { "--map $map: that is a picture to compare; name another file" }
    }

    private fun isAllowed(
        comparison: Comparison,
        allowed: Tolerance?,
    ): Boolean {
        val verdict = allowed?.judge(comparison) ?: return comparison.isIdentical
        val prefix = if (verdict.severity == Severity.WARN) "warning: " else ""
        verdict.messages.forEach { echo(prefix + it, err = true) }
        return verdict.severity != Severity.FAIL
    }

    private fun print(comparison: Comparison) {
        terminal.println(
            table {
                whitespace = Whitespace.PRE_WRAP
                cellBorders = Borders.LEFT_RIGHT
                tableBorders = Borders.ALL
                column(0) { whitespace = Whitespace.PRE }
                body { rows(comparison).forEach { (name, value) -> row(name, value) } }
            },
        )
    }

    private fun rows(comparison: Comparison): List<Pair<String, String>> {
        val worst = comparison.difference.worst ?: Pixel(0, 0)
        val worstPixel =
            listOf(
                "Worst pixel" to "${worst.x}, ${worst.y}",
                "  expected" to written(values(comparison.expected, worst)),
                "  actual" to written(values(comparison.actual, worst)),
            )
        return listOf("Pictures" to comparison.expected.description()) + figures(comparison) + worstPixel
    }

    private fun Picture.description(): String {
        val kind = if (this is BytePicture) "8 bits a channel" else "float"
        return "${width}x$height, $kind, ${if (hasAlpha) "RGBA" else "RGB"}"
    }

    private companion object {
        const val DIFFERENT = 1
    }
}
