package cga.measure.speed

import cga.framework.context.ContextKind
import cga.measure.accuracy.choices.PictureSize
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/**
 * How much is measured.
 *
 * @param runs rounds of everything that is timed; what is compared is interleaved.
 * @param size of the pictures where a part has not sizes of its own.
 * @param context null for OSMesa, the first choice.
 */
internal class SpeedSettings(
    val runs: Int,
    val size: PictureSize,
    val context: ContextKind?,
) {
    val kind: ContextKind get() = context ?: ContextKind.OSMESA
}

/** What was aimed at: at most [limit], in [unit], which may be empty. */
internal class Goal(
    private val what: String,
    private val measured: Double,
    private val limit: Double,
    private val unit: String,
) {
    val isMet: Boolean get() = measured <= limit

    override fun toString(): String {
        val (value, most) = listOf(measured, limit).map { "${SpeedTable.digits(it)} $unit".trim() }
        return "$what: at most $most. Measured: $value, **${if (isMet) "met" else "not met"}**."
    }
}

/** One part of the report. */
internal class SpeedSection(
    val tables: List<SpeedTable>,
    val goals: List<Goal> = emptyList(),
    val pictures: List<Picture> = emptyList(),
) {
    /** Goals, pictures, tables; the pictures lie in [folder] beside the document. */
    fun toMarkdown(folder: String): String {
        val goals = goals.joinToString("\n") { "- $it" }
        val pictures = pictures.map { "![${it.title}]($folder/${it.name}.svg)" }
        return (listOf(goals) + pictures + tables.map { it.toMarkdown() }).filter { it.isNotEmpty() }.joinToString("\n\n")
    }

    fun toJson(): JsonElement =
        buildJsonObject {
            put("goals", JsonArray(goals.map { goal -> buildJsonObject { put("goal", "$goal").also { put("met", goal.isMet) } } }))
            put("tables", JsonArray(tables.map { it.toJson() }))
        }
}
