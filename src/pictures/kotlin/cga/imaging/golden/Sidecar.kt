package cga.imaging.golden

import cga.framework.AtomicFile
import cga.imaging.JsonNode
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject
import java.nio.file.Path
import java.time.LocalDate
import java.time.format.DateTimeParseException
import kotlin.io.path.writeText

/**
 * The file beside an approved image that says what it is.
 *
 * @param picture checksum of the image's pixels, so that an image that was exchanged is noticed.
 * @param reason why the image was approved, in the words of whoever did.
 */
internal class Sidecar(
    val origin: Origin,
    val picture: String,
    val reason: String,
    val date: LocalDate,
) {
    /** Writes it to [file], whole or not at all. */
    fun write(file: Path) {
        val json =
            buildJsonObject {
                putJsonObject("approved") {
                    put("date", "$date")
                    put("reason", reason)
                }
                put("made", texts(origin.made))
                put("inputs", texts(origin.inputs))
                putJsonObject("machine") {
                    put("renderer", origin.machine.renderer)
                    put("driver", origin.machine.driver)
                    put("cpu", origin.machine.cpu.joinToString(" "))
                    put("settings", texts(origin.machine.settings))
                }
                put("picture", picture)
            }
        AtomicFile.write(file) { it.writeText(PRETTY.encodeToString(JsonElement.serializer(), json) + "\n") }
    }

    companion object {
        private val PRETTY =
            Json {
                prettyPrint = true
                prettyPrintIndent = "  "
            }

        /** Throws [cga.framework.InputError] naming the file, the place in it and what is wrong there. */
        fun read(file: Path): Sidecar {
            val node = JsonNode.read(file, "sidecar")
            node.allowOnly("approved", "made", "inputs", "machine", "picture")
            val approved = node.get("approved").apply { allowOnly("date", "reason") }
            val machine = node.get("machine").apply { allowOnly("renderer", "driver", "cpu", "settings") }
            return Sidecar(
                Origin(
                    Machine(
                        machine.get("renderer").text(),
                        machine.get("driver").text(),
                        machine.get("cpu").optionalText().split(' ').filter { it.isNotEmpty() },
                        machine.get("settings").texts(),
                    ),
                    node.get("made").texts(),
                    node.get("inputs").texts(),
                ),
                node.get("picture").text(),
                approved.get("reason").text(),
                date(approved.get("date")),
            )
        }

        private fun date(node: JsonNode): LocalDate =
            try {
                LocalDate.parse(node.text())
            } catch (_: DateTimeParseException) {
                node.fail("\"${node.text()}\" is no date: write it as 2026-01-31.")
            }

        private fun JsonNode.texts(): Map<String, String> = names.associateWith { get(it).optionalText() }

        private fun texts(values: Map<String, String>) = JsonObject(values.mapValues { JsonPrimitive(it.value) })
    }
}
