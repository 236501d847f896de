package cga.grading.corpus

/**
 * A named set of edits: a freedom of the sheet, another way to write the same, or a mistake.
 *
 * @param title in a sentence.
 * @param group what it is another form of; two of one group do not go together. Empty for mistakes.
 * @param without rewrites and groups that it does not go together with.
 * @param with rewrites that come before it.
 * @param file the name of its file, without `.txt`.
 * @param base what it is a rewrite of.
 */
internal class Rewrite(
    val name: String,
    val title: String,
    val group: String,
    val without: Set<String>,
    val with: List<String>,
    val edits: List<Edit>,
    val expectation: Expectation,
    val file: String,
    val base: Base = Base.COURSE,
) {
    fun goesWith(other: Rewrite): Boolean =
        group != other.group && listOf(other.name, other.group).none { it in without } && listOf(name, group).none { it in other.without }
}
