package cga.measure.accuracy.choices

import cga.measure.Sample

/**
 * What a choice costs and how far off it is.
 *
 * @param cost of one frame in ms, or of one operation in ns, over all runs.
 * @param max error; likewise [mean]. 0 for the truth itself.
 * @param truth what it is compared with: only choices that are to draw the same are compared with each other.
 */
public class Measured(
    public val name: String,
    public val cost: Sample,
    public val max: Double,
    public val mean: Double,
    public val truth: String = "",
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

/**
 * The choices that nobody has a reason to leave: no other is nearer to the truth and no slower. Only a spread that lies above the other's
 * altogether is slower: what noise may have put in order counts as equal.
 */
internal object Pareto {
    /** Those of [rows] on the front, by cost and [error], fastest first; of equals the first. Of several truths the commonest counts. */
    fun front(
        rows: List<Measured>,
        error: (Measured) -> Double = Measured::mean,
    ): List<Measured> {
        val sorted = rows.sortedWith(compareBy({ it.cost.median }, error))
        val same = sorted.groupBy { it.truth }.values.maxByOrNull { it.size }.orEmpty()
        return same.filterIndexed { i, row ->
            same.withIndex().none { (k, other) ->
                if (error(other) == error(row)) k < i else error(other) < error(row) && !isSlower(other, row)
            }
        }
    }

    private fun isSlower(
        row: Measured,
        other: Measured,
    ) = row.cost.lowest > other.cost.highest
}
