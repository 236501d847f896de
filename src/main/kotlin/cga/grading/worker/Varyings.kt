package cga.grading.worker

/**
 * What passes from the [vertex] to the [fragment] shader, by their sources. A variable that the fragment shader reads and no vertex shader
 * writes has no defined value, and another in each picture; some drivers do not even link it.
 */
internal class Varyings(
    private val vertex: String,
    private val fragment: String,
) {
    private val sent = declared(vertex, "out")
    private val received = declared(fragment, "in").filterKeys { uses(it, fragment) > 1 }

    /** What the fragment shader reads and the vertex shader does not write. */
    val missing: Set<String> = (received.keys - sent.keys).filter { uses(it, vertex) == 0 }.toSet()

    /** The fragment shader with each name that is [missing] replaced by the likest of its type that is not read yet; null where there is none. */
    fun matched(): String? {
        val spare = (sent - received.keys).filterKeys { uses(it, fragment) == 0 }.toMutableMap()
        return missing.fold(fragment) { text, name ->
            val alike = spare.filterValues { it == received[name] }.keys
            val meant = alike.maxByOrNull { it.commonPrefixWith(name).length + it.commonSuffixWith(name).length } ?: return null
            spare -= meant
            text.replace(Regex("""\b$name\b"""), meant)
        }
    }

    private companion object {
        fun uses(
            name: String,
            source: String,
        ) = Regex("""\b$name\b""").findAll(withoutComments(source)).count()

        fun withoutComments(source: String) = source.replace(Regex("""/\*[\s\S]*?\*/|//[^\n]*"""), " ")

        /** Name → type with qualifiers; blocks are matched by their own names and left out. */
        fun declared(
            source: String,
            direction: String,
        ): Map<String, String> =
            Regex("""(?<=[;}\n]|^)\s*((?:(?:flat|smooth|noperspective|centroid)\s+)*)$direction\s+(\w+)\s+([\w\s,\[\]]+);""")
                .findAll(withoutComments(source))
                .flatMap { found ->
                    found.groupValues[3].split(',').map {
                        it.substringBefore('[').trim() to "${found.groupValues[1]} ${found.groupValues[2]} ${it.substringAfter('[', "")}"
                    }
                }.toMap()
    }
}
