package cga.grading.report

import cga.grading.findings.Mistake

/**
 * What the analysis says, in the words of a report. It speaks English, in whole sentences with figures in them; `phrases.txt` gives each
 * sentence its words in either language. What is not in there stays as it is.
 */
internal class Phrases private constructor(
    private val messages: Messages,
) {
    private class Phrase(val pattern: Regex, val weight: Int, val words: String)

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
            phrase.pattern.matchEntire(text)?.let { match ->
                PLACE.replace(phrase.words) { place ->
                    val (number, kind) = place.destructured
                    val said = match.groupValues[number.toInt() + 1]
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
        if (NUMBERS.matches(text)) numbers(text) else translated(text, depth + 1) ?: text

    /** Between numbers with commas stand semicolons. */
    private fun numbers(text: String): String {
        val short = ZEROS.replace(text) { it.groupValues[1].removeSuffix(".") }
        return if (messages.language == Language.GERMAN) short.replace(", ", "; ").replace(POINT, ",") else short
    }

    private fun phrase(block: List<String>): Phrase {
        val said = block.drop(1).associate { it.substring(0, 2) to it.substring(CODE).removePrefix(" ") }
        // The last {n} of a line may hold a log of several.
        val between = PLACE.split(block[0]).map(Regex::escape)
        val places = PLACE.findAll(block[0]).map { if (it.groupValues[2] == NAME) "(\\S+)" else "([\\s\\S]*?)" } + ""
        val pattern = between.zip(places.toList()).joinToString("") { (text, place) -> text + place }
        return Phrase(Regex(pattern), PLACE.replace(block[0], "").length, said[messages.language.code] ?: block[0])
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
        private val NUMBERS = Regex("""[-+()\d.,;e°% ]*\d[-+()\d.,;e°% ]*""")
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
