package cga.grading.report

import cga.grading.findings.Mistake

/**
 * What the analysis says, in the words of a report. It speaks English, in whole sentences with figures in them; `phrases.txt` gives each
 * sentence its words in either language. What is not in there stays as it is.
 */
internal class Phrases private constructor(
    private val messages: Messages,
) {
    /**
     * A sentence with places to fill in.
     *
     * @param between what stands before, between and behind the places.
     * @param isName of each place, whether it holds one word.
     */
    private class Phrase(val between: List<String>, val isName: List<Boolean>, val words: String) {
        val weight = between.sumOf { it.length }

        /** What [text] has in the places, each as short as can be but for the last; null where it is another sentence. Looks at it once. */
        fun places(text: String): List<String>? {
            if (!text.startsWith(between[0])) return null
            var at = between[0].length
            val places = isName.indices.map { i ->
                val next = between[i + 1]
                val isLast = i == isName.lastIndex
                val end = if (isLast) text.length - next.length else text.indexOf(next, if (isName[i]) at + 1 else at)
                if (end < at || !text.startsWith(next, end)) return null
                val place = text.substring(at, end)
                if (isName[i] && (place.isEmpty() || place.any(Char::isWhitespace))) return null
                place.also { at = end + next.length }
            }
            return places.takeIf { at == text.length }
        }
    }

    private val phrases: List<Phrase> = blocks().map(::phrase).sortedByDescending { it.weight }

    /** [text] in the report's language. */
    fun say(text: String): String = translated(text, 0) ?: text

    /** Whether there are words for [text]. */
    fun knows(text: String): Boolean = translated(text, 0) != null

    private fun translated(text: String, depth: Int): String? {
        if (depth > DEEPEST || text.length > LONGEST) return null
        val sentences = text.split(SEPARATORS[0]).map { whole(it, depth) }
        if (sentences.all { it != null }) return sentences.joinToString(SEPARATORS[0])
        whole(text, depth)?.let { return it }
        return SEPARATORS.firstNotNullOfOrNull { separator ->
            val parts = text.split(separator)
            val said = parts.map { whole(it, depth) }
            if (parts.size < 2 || said.all { it == null }) null else parts.indices.joinToString(separator) { said[it] ?: parts[it] }
        }
    }

    private fun whole(text: String, depth: Int): String? =
        phrases.firstNotNullOfOrNull { phrase ->
            phrase.places(text)?.let { places ->
                PLACE.replace(phrase.words) { place ->
                    val (number, kind) = place.destructured
                    val said = places[number.toInt()]
                    if (kind.isEmpty()) argument(said, depth) else said
                }
            }
        } ?: named(text)

    /** The study names a mistake by its id. */
    private fun named(text: String): String? {
        val mistake = MISTAKES[text.substringBefore(' ')] ?: return null
        val where = text.substringAfter(' ', "")
        if ("; " in where) return null
        return messages.of(mistake).title + if (where.isEmpty()) "" else " ($where)"
    }

    private fun argument(text: String, depth: Int): String =
        if (text.all { it in NUMBERS } && text.any(Char::isDigit)) numbers(text) else translated(text, depth + 1) ?: text

    /** Between numbers with commas stand semicolons. */
    private fun numbers(text: String): String {
        val short = ZEROS.replace(text) { it.groupValues[1].removeSuffix(".") }
        return if (messages.language == Language.GERMAN) short.replace(", ", "; ").replace(POINT, ",") else short
    }

    private fun phrase(block: List<String>): Phrase {
        val said = block.drop(1).associate { it.substring(0, 2) to it.substring(CODE).removePrefix(" ") }
        val isName = PLACE.findAll(block[0]).map { it.groupValues[2] == NAME }.toList()
        return Phrase(PLACE.split(block[0]), isName, said[messages.language.code] ?: block[0])
    }

    companion object {
        private const val DEEPEST = 4
        private const val LONGEST = 4000
        private const val CODE = 3

        /** Stands behind the number of a place that one word fills. */
        private const val NAME = "."
        private val PLACE = Regex("""\{(\d)([!.]?)}""")
        private val ZEROS = Regex("""(\.\d*?)0+(?![\de])""")
        private val POINT = Regex("""(?<=\d)\.(?=\d)""")
        private const val NUMBERS = "0123456789-+().,;e°% "
        private val SEPARATORS = listOf("; ", ", ")
        private val MISTAKES = Mistake.entries.associateBy { it.id }

        /** The phrases in the language of [messages]. */
        fun of(messages: Messages): Phrases = Phrases(messages)

        /** The blocks of the file: the analysis's words, then the words of each language. */
        fun blocks(): List<List<String>> {
            val stream = checkNotNull(Phrases::class.java.getResourceAsStream("phrases.txt")) { "phrases.txt is missing from the program" }
            val lines = stream.reader().use { it.readLines() }.filterNot { it.startsWith("#") }
            return lines.joinToString("\n").split(Regex("\n{2,}")).map { it.trim().lines() }.filter { it.size > 1 }
        }
    }
}
