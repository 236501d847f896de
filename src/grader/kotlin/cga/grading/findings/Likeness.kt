package cga.grading.findings

import java.io.ByteArrayOutputStream
import java.security.MessageDigest

/** A part of a submission that two people do not make alike by chance. */
public enum class Part(
    public val id: String,
) {
    /** Its own sources. */
    KOTLIN("kotlin"),

    /** The shaders that it ran with. */
    SHADERS("shaders"),

    /** What it handed to OpenGL. */
    CAPTURE("capture"),
}

/**
 * A submission without names and layout: whose key of a part is another's has the same there.
 *
 * @param keys of the parts that there are, each as [keyOf] makes it.
 * @param solution the parts that are the same as the solution's.
 */
public class Likeness(
    public val keys: Map<Part, String> = emptyMap(),
    public val solution: Set<Part> = emptySet(),
) {
    /** The parts that are the same here and in [other]. */
    internal fun shared(other: Likeness): Set<Part> = keys.filter { (part, key) -> other.keys[part] == key }.keys

    internal companion object {
        private const val LENGTH = 64

        /** One key of many [pieces], whatever order they come in. */
        fun keyOf(pieces: Collection<ByteArray>): String {
            val sums = pieces.map { hex(sha256(it)) }.sorted()
            return hex(sha256(ByteArrayOutputStream().apply { sums.forEach { write(it.toByteArray()) } }.toByteArray()))
        }

        /** Whether [text] is what [keyOf] makes. */
        fun isKey(text: String): Boolean = text.length == LENGTH && text.all { it in '0'..'9' || it in 'a'..'f' }

        private fun sha256(bytes: ByteArray) = MessageDigest.getInstance("SHA-256").digest(bytes)

        private fun hex(bytes: ByteArray) = bytes.joinToString("") { "%02x".format(it) }
    }
}
