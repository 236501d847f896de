package cga.measure.speed

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.framework.context.ContextKind
import cga.measure.MarkedDocument
import cga.measure.accuracy.choices.Host
import cga.measure.accuracy.choices.PictureSize
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * docs/performance.md: each part fills the marker `table:PART`, and stands with all its numbers in the JSON file beside the document.
 *
 * @param file the document; it has the markers of all parts that are asked for.
 */
public class SpeedReport(private val file: Path) {
    private val images = file.toAbsolutePath().resolveSibling("images")
    private val json = file.resolveSibling("${file.nameWithoutExtension}.json")

    /**
     * Measures the [parts] and writes them, the others stay; [say] is told what is being done.
     *
     * @param runs rounds of everything that is timed; what is compared is interleaved.
     * @param width of the pictures in pixels, and their [height], where a part has not sizes of its own.
     * Throws [InputError] where the document lacks a marker, a program is missing or a file cannot be written.
     */
    public fun write(
        parts: List<String>,
        runs: Int,
        width: Int,
        height: Int,
        context: ContextKind?,
        say: (String) -> Unit,
    ) {
        // Measuring takes minutes: a document that cannot take the result is found out before.
        val document = MarkedDocument.read(file)
        (parts + MACHINE).forEach { document.require(marker(it)) }
        val settings = SpeedSettings(runs, PictureSize(width, height), context)
        val machine = Speeds(settings).use { "${Host.describe(it.renderer, it.version)}; load before: ${Host.load()}, $runs rounds." }
        val sections = parts.associateWith { part -> PARTS.getValue(part).also { say("measuring $part") }(settings) }
        writePictures(sections.values.flatMap { it.pictures })
        writeJson(sections.mapValues { it.value.toJson() } + (MACHINE to JsonPrimitive(machine)))
        val contents = sections.mapValues { "${it.value.toMarkdown(images.fileName.toString())}\n\n*$machine*" } + (MACHINE to machine)
        contents.entries.fold(document) { filled, (part, content) -> filled.with(marker(part), content) }.write()
    }

    private fun writePictures(pictures: List<Picture>) {
        if (pictures.isEmpty()) return
        try {
            images.createDirectories()
        } catch (e: IOException) {
            throw InputError("cannot make the folder $images for the pictures: name a document elsewhere.", e)
        }
        pictures.forEach { it.write(images) }
    }

    private fun writeJson(fresh: Map<String, JsonElement>) {
        val old = if (json.exists()) Json.parseToJsonElement(json.readText()).jsonObject else emptyMap()
        AtomicFile.write(json) { it.writeText(PRETTY.encodeToString(JsonElement.serializer(), JsonObject(old + fresh)) + "\n") }
    }

    public companion object {
        private val PARTS: Map<String, (SpeedSettings) -> SpeedSection> =
            mapOf(
                "process" to ProcessPart::measure,
                "frame" to FramePart::measure,
                "submission" to SubmissionPart::measure,
                "fragment" to FragmentPart::measure,
                "micro" to MicroPart::measure,
                "commands" to CommandPart::measure,
                "loop" to LoopPart::measure,
            )

        /** The names of all parts. */
        public val parts: List<String> = PARTS.keys.toList()
        private const val MACHINE = "machine"
        private val PRETTY = Json { prettyPrint = true }

        private fun marker(part: String) = "table:$part"
    }
}
