package cga.grading.submission

/**
 * What of a Kotlin or Java source is code and what is said in strings and comments, found in one pass over [text], however long a string is
 * and however deep comments lie in each other.
 */
internal class SourceText(
    private val text: String,
) {
    /** Where in [text] each string literal's content begins, and that content as it is written. */
    val literals: Map<Int, String> get() = found

    private val found = LinkedHashMap<Int, String>()
    private val plain = text.toCharArray()

    /** [text] with blanks for comments and for what stands in strings; lines stay where they are. */
    val code: String

    init {
        var at = 0
        while (at < text.length) {
            at = when {
                text.startsWith("//", at) -> blank(at, lineEnd(at))
                text.startsWith("/*", at) -> blank(at, commentEnd(at))
                text.startsWith(RAW, at) -> literal(at + RAW.length, rawEnd(at + RAW.length)) + RAW.length
                text[at] == '"' -> literal(at + 1, stringEnd(at + 1)) + 1
                // A character: '"' begins no string.
                text[at] == '\'' -> characterEnd(at)
                else -> at + 1
            }
        }
        code = String(plain)
    }

    private fun literal(from: Int, to: Int): Int {
        found[from] = text.substring(from, to)
        return blank(from, to)
    }

    private fun blank(from: Int, to: Int): Int {
        for (i in from until to) if (plain[i] != '\n') plain[i] = ' '
        return to
    }

    private fun lineEnd(from: Int) = text.indexOf('\n', from).orEnd()

    /** Comments of Kotlin lie in each other. */
    private fun commentEnd(from: Int): Int {
        var depth = 0
        var at = from
        while (at < text.length) {
            when {
                text.startsWith("/*", at) -> depth++.also { at += 2 }
                text.startsWith("*/", at) -> {
                    at += 2
                    if (--depth == 0) return at
                }
                else -> at++
            }
        }
        return text.length
    }

    private fun rawEnd(from: Int) = text.indexOf(RAW, from).orEnd()

    /** The end of a string's line where nothing closes it. */
    private fun stringEnd(from: Int): Int {
        var at = from
        while (at < text.length && text[at] != '"' && text[at] != '\n') at += if (text[at] == '\\') 2 else 1
        return minOf(at, text.length)
    }

    private fun characterEnd(from: Int): Int {
        val end = if (text.startsWith("\\", from + 1)) from + 3 else from + 2
        return if (text.startsWith("'", end)) end + 1 else from + 1
    }

    private fun Int.orEnd() = if (this < 0) text.length else this

    private companion object {
        const val RAW = "\"\"\""
    }
}
