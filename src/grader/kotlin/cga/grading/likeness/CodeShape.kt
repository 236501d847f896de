package cga.grading.likeness

/** Source text without comments, taken down to what a copy keeps when it is renamed and laid out anew. */
internal object CodeShape {
    private const val WORD = 'w'
    private const val LONGEST_NUMBER = 100

    /**
     * [code] with one letter for every word and without blanks, [optional] signs, and statements that a line begins with and whose
     * first word is one of [without]; numbers by their value.
     */
    fun of(code: String, optional: String = "", without: Set<String> = emptySet()): String {
        val shape = StringBuilder()
        for (line in code.lineSequence()) add(statements(line.trim(), without), optional, shape)
        return "$shape"
    }

    /** [line] without statements at its beginning whose first word is one of [without]. */
    private fun statements(line: String, without: Set<String>): String {
        var at = 0
        while (at < line.length && line.substring(at).trimStart().takeWhile(::isOfWord) in without) {
            at = line.indexOf(';', at).let { if (it < 0) line.length else it + 1 }
        }
        return line.substring(at)
    }

    private fun add(line: String, optional: String, shape: StringBuilder) {
        var at = 0
        while (at < line.length) {
            val first = line[at]
            val end = if (isOfWord(first) || isPoint(line, at)) end(line, at) else at + 1
            when {
                first.isDigit() || (first == '.' && end > at + 1) -> shape.append(number(line.substring(at, end))).append(' ')
                isOfWord(first) -> shape.append(WORD)
                !first.isWhitespace() && first !in optional -> shape.append(first)
            }
            at = end
        }
    }

    /** `.5` is a number, `a.b` has none. */
    private fun isPoint(line: String, at: Int) = line[at] == '.' && line.getOrNull(at + 1)?.isDigit() == true

    /** `1.` is a number in GLSL; in Kotlin there are `1.toFloat()` and `1..2`. */
    private fun isLastPoint(line: String, at: Int) =
        line[at] == '.' && line.getOrNull(at + 1).let { it == null || (it != '.' && !isOfWord(it)) }

    private fun end(line: String, from: Int): Int {
        val isNumber = line[from].isDigit() || line[from] == '.'
        var at = from + 1
        while (at < line.length && (isOfWord(line[at]) || (isNumber && (isPoint(line, at) || isLastPoint(line, at))))) at++
        return at
    }

    /** `1`, `1.0`, `1f` and `1.0F` are one number; what is none is itself. */
    private fun number(text: String): String =
        text.takeIf { it.length < LONGEST_NUMBER }?.lowercase()?.trimEnd('f', 'l', 'u')?.toDoubleOrNull()?.toString() ?: text

    private fun isOfWord(char: Char) = char.isLetterOrDigit() || char == '_'
}
