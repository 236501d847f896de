package cga.grading.worker

/**
 * What passes from the [vertex] to the [fragment] shader, by their sources. A variable that the fragment shader reads and no vertex shader
 * writes has no defined value, and another in each picture; some drivers do not even link it.
 */
internal class Varyings(
    vertex: String,
    private val fragment: String,
) {
    private val vertexText = withoutComments(vertex)
    private val fragmentText = withoutComments(fragment)
    private val sent = declared(vertexText, "out")
    private val received = declared(fragmentText, "in").filterKeys { uses(it, fragmentText) > 1 }

    /** What the fragment shader reads and the vertex shader does not write. */
    val missing: Set<String> = (received.keys - sent.keys).filter { uses(it, vertexText) == 0 }.toSet()

    /** The fragment shader with each name that is [missing] replaced by the likest of its type that is not read yet; null where there is none. */
    fun matched(): String? {
        val spare = (sent - received.keys).filterKeys { uses(it, fragmentText) == 0 }.toMutableMap()
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
            text: String,
        ) = Regex("""\b$name\b""").findAll(text).count()

        /** Name → type with qualifiers; blocks are matched by their own names and left out. */
        fun declared(
            text: String,
            direction: String,
        ): Map<String, String> =
            Regex("""(?<=[;}\n]|^)\s*((?:(?:flat|smooth|noperspective|centroid)\s+)*)$direction\s+(\w+)\s+([\w\s,\[\]]+);""")
                .findAll(text)
                .flatMap { found ->
                    found.groupValues[3].split(',').map {
                        it.substringBefore('[').trim() to "${found.groupValues[1]} ${found.groupValues[2]} ${it.substringAfter('[', "")}"
                    }
                }.toMap()
    }
}
