package cga.imaging

import cga.framework.Home
import cga.framework.InputError
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Path

/** A value in a JSON file that knows where it stands, so that every error names the file, the place in it and the cure. */
public class JsonNode private constructor(
    public val file: Path,
    private val place: String,
    private val element: JsonElement,
) {
    /** Throws an [InputError] that says [problem] of this value. */
    public fun fail(problem: String): Nothing = throw InputError(if (place.isEmpty()) "$file: $problem" else "$file: $place: $problem")

    /** The names in this object. Fails where it is none. */
    public val names: Set<String> get() = objectOrFail().keys

    /** Fails where this object holds anything but [known], as misspelt names are. */
    public fun allowOnly(vararg known: String) {
        val unknown = (names - known.toSet()).firstOrNull() ?: return
        fail("\"$unknown\" is not known here: write ${known.joinToString { "\"$it\"" }}.")
    }

    public fun find(name: String): JsonNode? =
        objectOrFail()[name]?.let { JsonNode(file, if (place.isEmpty()) name else "$place.$name", it) }

    public fun get(name: String): JsonNode = find(name) ?: fail("\"$name\" is missing: add it.")

    /** The values of this list, at least one. */
    public fun list(): List<JsonNode> {
        val array = element as? JsonArray ?: fail("must be a list: write [ … ].")
        if (array.isEmpty()) fail("is an empty list: put something into it, or leave it away.")
        return array.mapIndexed { i, value -> JsonNode(file, "$place[$i]", value) }
    }

    public fun text(): String = optionalText().ifBlank { fail("must not be empty.") }

    /** A text that may be empty. */
    public fun optionalText(): String = (element as? JsonPrimitive)?.takeIf { it.isString }?.content ?: fail("must be a text in quotes.")

    /** A number, or a text that reads as one to [parse]; [form] says in the error what is wanted. */
    public fun <T : Any> number(
        form: String,
        parse: (String) -> T?,
    ): T {
        val content = (element as? JsonPrimitive)?.content ?: fail("must be $form.")
        return parse(content.trim()) ?: fail("\"$content\" is not understood: write $form.")
    }

    public fun flag(): Boolean =
        (element as? JsonPrimitive)?.takeIf { !it.isString }?.content?.toBooleanStrictOrNull() ?: fail("must be true or false.")

    private fun objectOrFail(): JsonObject = element as? JsonObject ?: fail("must be an object: write { … }.")

    public companion object {
        /** The value in [file], which errors call a [kind] ("tolerance", …). Throws [InputError] where it cannot be read or is no JSON. */
        public fun read(
            file: Path,
            kind: String,
        ): JsonNode {
            val text = Home.read(file, kind).decodeToString()
            return try {
                JsonNode(file, "", Json.parseToJsonElement(text))
            } catch (e: SerializationException) {
                throw InputError("$kind file $file is not JSON (${e.message.orEmpty().lineSequence().first()}): correct it.", e)
            }
        }
    }
}
