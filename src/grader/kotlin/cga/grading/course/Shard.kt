package cga.grading.course

import cga.framework.InputError

/** The part [index] of [count] of a course, by the names of the submissions: it does not depend on which others there are. */
public class Shard(
    public val index: Int,
    public val count: Int,
) {
    /** Whether [submission] belongs to this part. */
    public operator fun contains(submission: Submission): Boolean =
        (sha256(submission.folder).take(DIGITS).toLong(radix = 16) % count).toInt() == index - 1

    override fun toString(): String = "$index/$count"

    public companion object {
        private const val DIGITS = 12
        private val FORM = Regex("""(\d{1,5})/(\d{1,5})""")

        /** Everything. */
        public val WHOLE: Shard = Shard(1, 1)

        /** Reads "2/4". Throws [InputError] where [text] is nothing like it. */
        public fun of(text: String): Shard {
            val numbers = FORM.matchEntire(text)?.destructured?.let { (index, count) -> index.toInt() to count.toInt() }
            val (index, count) = numbers ?: (0 to 0)
            if (index !in 1..count) throw InputError("shard \"$text\" is not understood: write which of how many parts, as 2/4.")
            return Shard(index, count)
        }
    }
}
