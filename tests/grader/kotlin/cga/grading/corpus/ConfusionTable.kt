package cga.grading.corpus

/** How often the grader is right, by set, as Markdown. */
internal object ConfusionTable {
    fun of(judged: Map<String, Judgement>): String {
        val sets = Corpus.all.groupBy { it.set }
        val (correct, mistaken) = sets.keys.partition { set -> sets.getValue(set).first().expectation.mistakes.isEmpty() }

        fun row(set: String, cells: (List<Judgement>) -> List<Int>): String {
            val all = sets.getValue(set)
            val some = all.mapNotNull { judged[it.name] }
            return (listOf(set, "${some.size} of ${all.size}") + cells(some)).joinToString(" | ", "| ", " |")
        }
        return HEAD_CORRECT + correct.joinToString("\n", postfix = "\n\n") { set -> row(set) { some -> correctCells(some) } } +
            HEAD_MISTAKEN + mistaken.joinToString("\n") { set -> row(set) { some -> mistakenCells(some) } }
    }

    private fun correctCells(some: List<Judgement>) = listOf(
        some.count { it.answer == Answer.CLEAN },
        some.count {
            it.answer ==
                Answer.FALSE_ALARM
        },
    )

    private fun mistakenCells(some: List<Judgement>) =
        listOf(Answer.NAMED, Answer.WRONG, Answer.UNKNOWN, Answer.MISSED).map { answer -> some.count { it.answer == answer } } +
            some.count { it.elsewhere.isNotEmpty() }

    private const val HEAD_CORRECT = "| correct submissions | judged | full points | false positives |\n|---|--:|--:|--:|\n"
    private const val HEAD_MISTAKEN =
        "| mistaken submissions | judged | named | wrong name | unknown | missed | points lost elsewhere |\n|---|--:|--:|--:|--:|--:|--:|\n"
}
