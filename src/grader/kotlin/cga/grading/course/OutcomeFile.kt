package cga.grading.course

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.grading.findings.FailureReason
import cga.grading.findings.FindingsFile
import cga.grading.findings.Graded
import cga.grading.findings.Likeness
import cga.grading.findings.LogExcerpt
import cga.grading.findings.Outcome
import cga.grading.findings.Part
import cga.grading.findings.Refused
import cga.grading.findings.RunFacts
import cga.imaging.JsonNode
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import kotlin.io.path.writeText

/** What is kept of a submission that has been graded: its outcome, and what it was made from. */
internal class StoredOutcome(
    val name: String,
    val checksum: String,
    val seconds: Double,
    val outcome: Outcome,
)

/** `outcome.json` in the folder of a submission, written last: where it is, the submission is done. The findings lie beside it. */
internal object OutcomeFile {
    const val NAME = "outcome.json"
    private const val MAX_BYTES = 16L shl 20
    private const val MOST_LOGS = 16
    private const val MOST_LOG = 200_000
    private const val MOST_TEXT = 8000
    private const val FORMAT = 1

    /** Throws [IllegalArgumentException] where the findings break their limits. */
    fun write(stored: StoredOutcome, folder: Path) {
        val outcome = stored.outcome
        if (outcome is Graded) FindingsFile.write(outcome.findings, folder)
        val json =
            buildJsonObject {
                put("format", FORMAT)
                put("name", stored.name)
                put("checksum", stored.checksum)
                put("seconds", stored.seconds)
                if (outcome is Refused) {
                    putJsonObject("refused") {
                        put("reason", outcome.reason.id)
                        put("detail", outcome.detail.take(MOST_TEXT))
                    }
                }
                put("facts", facts(outcome.facts))
            }
        AtomicFile.write(folder.resolve(NAME)) { it.writeText(Json.encodeToString(JsonElement.serializer(), json) + "\n") }
    }

    private fun facts(facts: RunFacts) =
        buildJsonObject {
            facts.kind?.let { put("kind", it.take(MOST_TEXT)) }
            facts.edition?.let { put("edition", it.take(MOST_TEXT)) }
            facts.compiler?.let { put("compiler", it.take(MOST_TEXT)) }
            if (!facts.isConfined) put("unconfined", true)
            if (facts.likeness.keys.isNotEmpty()) put("likeness", likeness(facts.likeness))
            facts.peakBytes?.let { put("peakBytes", it) }
            put("seconds", JsonObject(facts.seconds.filterValues { it.isFinite() }.mapValues { JsonPrimitive(it.value) }))
            val logs = facts.logs.take(MOST_LOGS)
            if (logs.isNotEmpty()) put("logs", JsonArray(logs.map(::log)))
        }

    private fun likeness(likeness: Likeness) =
        buildJsonObject {
            likeness.keys.forEach { (part, key) -> put(part.id, key) }
            put("solution", likeness.solution.joinToString(" ") { it.id })
        }

    private fun log(log: LogExcerpt) =
        buildJsonObject {
            put("title", log.title.take(MOST_TEXT))
            put("text", shortened(log.text))
        }

    private fun shortened(text: String) =
        if (text.length <= MOST_LOG) text else text.take(MOST_LOG / 2) + "\n\n[…]\n\n" + text.takeLast(MOST_LOG / 2)

    /** The outcome in [folder]. Throws [InputError] where there is none or it cannot be read. */
    fun read(folder: Path): StoredOutcome {
        val file = folder.resolve(NAME)
        if (!Files.isRegularFile(file, NOFOLLOW_LINKS) ||
            Files.size(file) > MAX_BYTES
        ) {
            throw InputError("$file is not the result of a submission.")
        }
        val node = JsonNode.read(file, "outcome")
        node.allowOnly("format", "name", "checksum", "seconds", "refused", "facts")
        if (node.get("format").number("a number", String::toIntOrNull) !=
            FORMAT
        ) {
            node.fail("was written by another version: grade without --resume.")
        }
        val facts = readFacts(node.get("facts"))
        val refused = node.find("refused")?.let { refused ->
            val reason = FailureReason.entries.find { it.id == refused.get("reason").text() } ?: refused.fail("has an unknown reason.")
            Refused(reason, refused.get("detail").optionalText(), facts)
        }
        val outcome = refused ?: Graded(FindingsFile.read(folder), facts)
        return StoredOutcome(node.get("name").optionalText(), node.get("checksum").text(), node.get("seconds").seconds(), outcome)
    }

    private fun readFacts(node: JsonNode): RunFacts {
        val seconds = node.get("seconds")
        return RunFacts(
            node.find("kind")?.optionalText(),
            node.find("edition")?.optionalText(),
            node.find("compiler")?.optionalText(),
            seconds.names.associateWith { seconds.get(it).seconds() },
            node.find("peakBytes")?.number("a whole number", String::toLongOrNull),
            node.find("logs")?.list().orEmpty().map { LogExcerpt(it.get("title").optionalText(), it.get("text").optionalText()) },
            isConfined = node.find("unconfined") == null,
            node.find("likeness")?.let(::readLikeness) ?: Likeness(),
        )
    }

    private fun readLikeness(node: JsonNode): Likeness {
        node.allowOnly("solution", *Part.entries.map { it.id }.toTypedArray())
        val keys = Part.entries.mapNotNull { part -> node.find(part.id)?.text()?.let { part to it } }.toMap()
        if (!keys.values.all(Likeness::isKey)) node.fail("has a key that is none.")
        val solution = node.get("solution").optionalText().split(' ')
        return Likeness(keys, Part.entries.filterTo(linkedSetOf()) { it.id in solution })
    }

    private fun JsonNode.seconds() = number("a number") { it.toDoubleOrNull()?.takeIf(Double::isFinite) }
}
