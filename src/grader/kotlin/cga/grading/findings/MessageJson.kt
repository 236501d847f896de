package cga.grading.findings

import cga.imaging.JsonNode
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** How much a message may hold, all that is in it counted together. */
private const val MOST_PARTS = 200

/** [message] as `{"key": …, "with": [{"name": …}, {"number": …}, {"message": …}, {"list": …}]}`; a number that is not finite as its name. */
internal fun messageJson(message: Message): JsonObject =
    buildJsonObject {
        put("key", message.key)
        if (message.arguments.isNotEmpty()) put("with", JsonArray(message.arguments.map(::argumentJson)))
    }

private fun argumentJson(argument: Any): JsonObject =
    buildJsonObject {
        when {
            argument is Message -> put("message", messageJson(argument))
            argument is Number && argument.toDouble().isFinite() -> put("number", JsonPrimitive(argument.toDouble()))
            // JSON lists of ours are never empty: one that is says nothing.
            argument is List<*> && argument.isNotEmpty() -> put("list", JsonArray(argument.map { argumentJson(it ?: "") }))
            argument is List<*> -> put("name", "")
            else -> put("name", "$argument".take(Limit.TEXT))
        }
    }

/** Reads what [messageJson] writes, from whoever it comes. */
internal class MessageReader(private val node: JsonNode) {
    private var left = MOST_PARTS

    fun message(): Message = message(node)

    private fun message(node: JsonNode): Message {
        node.allowOnly("key", "with")
        return Message(text(node.get("key")), node.find("with")?.list().orEmpty().map(::argument))
    }

    private fun argument(node: JsonNode): Any {
        if (--left < 0) node.fail("the message has more than $MOST_PARTS parts.")
        node.allowOnly("name", "number", "message", "list")
        node.find("name")?.let { return text(it) }
        node.find("number")?.let { return it.number("a finite number") { text -> text.toDoubleOrNull()?.takeIf(Double::isFinite) } }
        node.find("message")?.let { return message(it) }
        return node.get("list").list().map(::argument)
    }

    private fun text(node: JsonNode) =
        node.optionalText().also {
            if (it.length >
                Limit.TEXT
            ) {
                node.fail("is ${it.length} characters long; at most ${Limit.TEXT} are read.")
            }
        }
}
