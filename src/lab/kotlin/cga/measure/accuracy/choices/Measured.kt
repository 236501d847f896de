package cga.measure.accuracy.choices

import cga.measure.Sample

/**
 * What a choice costs and how far off it is.
 *
 * @param cost of one frame in ms, or of one operation in ns, over all runs.
 * @param max error; likewise [mean]. 0 for the truth itself.
 */
public class Measured(
    public val name: String,
    public val cost: Sample,
    public val max: Double,
    public val mean: Double,
)

/** Choices of one kind, beside each other. [note] tells what was timed and compared; units are written out. */
public class MeasuredGroup(
    public val title: String,
    public val note: String,
    public val costUnit: String,
    public val errorUnit: String,
    public val rows: List<Measured>,
) {
    /** The group as Markdown: a heading, the note, a table. Those on the front are marked. */
    public fun toMarkdown(): String {
        val front = Pareto.front(rows)
        val header =
            "| choice | $costUnit | lowest – highest | max error, $errorUnit | mean error | front |\n" +
                "|---|---:|---:|---:|---:|:---:|"
        val lines =
            rows.map { row ->
                val (cost, lowest, highest) = listOf(row.cost.median, row.cost.lowest, row.cost.highest).map(::digits)
                "| ${row.name} | $cost | $lowest – $highest | ${digits(row.max)} | ${digits(row.mean)} | ${if (row in front) "●" else ""} |"
            }
        return "#### $title\n\n$note\n\n$header\n${lines.joinToString("\n")}"
    }

    internal companion object {
        /** Three digits, and no more zeros than those need. */
        fun digits(x: Double): String =
            when {
                !x.isFinite() -> "–"
                x == 0.0 -> "0"
                x >= 1e5 || x < 1e-3 -> "%.1e".format(null, x)
                x >= 100 -> "%.0f".format(null, x)
                x >= 10 -> "%.1f".format(null, x)
                x >= 1 -> "%.2f".format(null, x)
                else -> "%.3f".format(null, x)
            }
    }
}

/** The choices that nobody has a reason to leave: no other is both faster and nearer to the truth. */
internal object Pareto {
    /** Those of [rows] on the front, by median cost and [error], fastest first; of equals the first. */
    fun front(
        rows: List<Measured>,
        error: (Measured) -> Double = Measured::mean,
    ): List<Measured> {
        val front = ArrayList<Measured>()
        for (row in rows.sortedWith(compareBy({ it.cost.median }, error))) {
            if (front.isEmpty() || error(row) < error(front.last())) front += row
        }
        return front
    }
}
