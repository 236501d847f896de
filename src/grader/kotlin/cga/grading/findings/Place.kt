package cga.grading.findings

/**
 * A line of the submission's own, to be shown: nothing is concluded from it, for it may be anything.
 *
 * @param file its path, as far as it is known.
 * @param line counted from 1.
 * @param source the lines around it, and [first] the number of the first of them; empty where they are not known.
 */
public class Place(
    public val file: String,
    public val line: Int,
    public val source: List<String> = emptyList(),
    public val first: Int = 1,
) {
    /** This place with the lines of [text], which is the whole file, around it. A line that the file does not have stays without. */
    public fun within(text: String): Place {
        val lines = text.removeSuffix("\n").lines()
        if (line !in 1..lines.size) return this
        val from = maxOf(1, line - AROUND)
        return Place(file, line, lines.subList(from - 1, minOf(lines.size, line + AROUND)).map { it.take(LONGEST) }, from)
    }

    override fun toString(): String = "$file:$line"

    public companion object {
        private const val AROUND = 3
        internal const val MOST_LINES = 2 * AROUND + 1
        internal const val LONGEST = 200

        /** The place of a [call] as a capture tells it, `package/File.kt:line`. */
        public fun of(call: String): Place = Place(call.substringBeforeLast(':'), call.substringAfterLast(':').toIntOrNull() ?: 0)
    }
}

/**
 * How well mistakes explain the pictures: the model is drawn with them, for every moment.
 *
 * @param explained the share of the difference between the submission's pictures and the expected ones that is gone then, at most 1.
 * @param left what is left of it: the root of the mean square, of 255.
 */
public class Proof(
    public val explained: Double,
    public val left: Double,
)
