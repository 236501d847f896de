package cga.grading.report

/**
 * Text of unknown origin without what is no character of XML 1.0, what a terminal obeys, and what turns the reading direction of its
 * surroundings; each is shown as �. Line ends become \n. What markup means stays: those who write HTML, XML or CSV escape it.
 */
internal fun clean(text: String): String {
    val plain = COLOR.replace(text, "").replace("\r\n", "\n").replace('\r', '\n')
    return buildString(plain.length) {
        var i = 0
        while (i < plain.length) {
            val code = plain.codePointAt(i)
            appendCodePoint(if (isHarmless(code)) code else REPLACEMENT)
            i += Character.charCount(code)
        }
    }
}

/** As [clean], in one line of at most [limit] characters. */
internal fun cleanLine(text: String, limit: Int = 300): String =
    clean(text).replace(Regex("""\s+"""), " ").trim().let {
        if (it.length <=
            limit
        ) {
            it
        } else {
            it.take(limit - 1).trimEnd(Char::isHighSurrogate) + "…"
        }
    }

private fun isHarmless(code: Int) =
    when (code) {
        '\n'.code, '\t'.code -> true
        in 0x20..0x7E, in 0xA0..0xD7FF, in 0xE000..0xFFFD, in 0x10000..0x10FFFF -> code !in DIRECTIONS
        else -> false
    }

// Embeddings, overrides and isolates of the bidirectional algorithm, and the separators that some readers take for line ends.
private val DIRECTIONS = (0x202A..0x202E) + (0x2066..0x2069) + listOf(0x200E, 0x200F, 0x2028, 0x2029)
private const val REPLACEMENT = 0xFFFD

// What compilers colour their messages with.
private val COLOR = Regex("""\u001B\[[0-9;]*m""")
