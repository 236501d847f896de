package cga.measure.speed

import cga.measure.Sample
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlin.math.abs

/** One line of a [SpeedTable]: a sample for each column, null where nothing was measured. */
internal class SpeedRow(
    val name: String,
    val cells: List<Sample?>,
) {
    constructor(name: String, vararg cells: Sample?) : this(name, cells.asList())
}

/**
 * Measurements beside each other.
 *
 * @param note what was measured and how, a sentence or two.
 * @param first what the rows are.
 * @param columns what the cells are, with their unit.
 */
internal class SpeedTable(
    val title: String,
    val note: String,
    val first: String,
    val columns: List<String>,
    val rows: List<SpeedRow>,
) {
    /** The median and, where several were measured, the lowest and the highest. */
    fun toMarkdown(): String {
        val header = "| $first | ${columns.joinToString(" | ")} |\n|---|${"---:|".repeat(columns.size)}"
        return "#### $title\n\n$note\n\n$header\n${rows.joinToString(
            "\n",
        ) { "| ${it.name} | ${it.cells.joinToString(" | ", transform = ::text)} |" }}"
    }

    fun toJson(): JsonElement =
        buildJsonObject {
            put("title", title)
            put("columns", JsonArray(columns.map(::JsonPrimitive)))
            put("rows", JsonArray(rows.map(::json)))
        }

    private fun json(row: SpeedRow): JsonElement =
        buildJsonObject {
            put("name", row.name)
            put("cells", JsonArray(row.cells.map { it?.let(::json) ?: JsonNull }))
        }

    private fun json(sample: Sample): JsonElement =
        buildJsonObject {
            put("median", sample.median)
            put("lowest", sample.lowest)
            put("highest", sample.highest)
        }

    internal companion object {
        private fun text(sample: Sample?): String =
            when {
                sample == null -> "–"
                sample.lowest == sample.highest -> digits(sample.median)
                else -> "${digits(sample.median)} (${digits(sample.lowest)}–${digits(sample.highest)})"
            }

        /** Three digits; whole numbers whole. */
        fun digits(x: Double): String =
            when {
                x == Math.rint(x) && abs(x) < 1e7 -> "%.0f".format(null, x)
                abs(x) >= 1e6 -> "%.2e".format(null, x)
                abs(x) >= 100 -> "%.0f".format(null, x)
                abs(x) >= 10 -> "%.1f".format(null, x)
                abs(x) >= 1 -> "%.2f".format(null, x)
                else -> "%.3f".format(null, x)
            }
    }
}
