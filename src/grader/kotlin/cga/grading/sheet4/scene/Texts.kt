package cga.grading.sheet4.scene

import cga.grading.findings.Message
import org.joml.Vector3dc

/** The text `scene.`[key] of the message files, with numbers, names, vectors, moments, other texts or lists of these in its places. */
internal fun say(key: String, vararg values: Any): Message = Message("scene.$key", values.map(::argument))

private fun argument(value: Any): Any =
    when (value) {
        is Number, is String, is Message -> value
        is Vector3dc -> listOf(value.x(), value.y(), value.z())
        is List<*> -> value.map { argument(checkNotNull(it)) }
        else -> value.toString()
    }
