package cga.grading.corpus

import kotlin.math.abs

/** How often the grader is right, by set, as Markdown. */
internal object ConfusionTable {
    fun of(judged: Map<String, Judgement>): String {
        val sets = Corpus.all.groupBy { it.set }
        val (unfinished, finished) = sets.keys.partition { sets.getValue(it).first().expectation.points != null }
        val (correct, mistaken) = finished.partition { set -> sets.getValue(set).first().expectation.mistakes.isEmpty() }

        fun row(set: String, cells: (List<Judgement>) -> List<Any>): String {
            val all = sets.getValue(set)
            val some = all.mapNotNull { judged[it.name] }
            return (listOf(set, "${some.size} of ${all.size}") + cells(some)).joinToString(" | ", "| ", " |")
        }

        fun table(head: String, some: List<String>, cells: (List<Judgement>) -> List<Any>) =
            head + some.joinToString("\n") { row(it, cells) }
        return listOf(
            table(HEAD_CORRECT, correct, ::correctCells),
            table(HEAD_MISTAKEN, mistaken, ::mistakenCells),
            table(HEAD_UNFINISHED, unfinished, ::unfinishedCells),
        ).joinToString("\n\n")
    }

    private fun correctCells(some: List<Judgement>) =
        listOf(Answer.CLEAN, Answer.FALSE_ALARM).map { answer -> some.count { it.answer == answer } }

    private fun mistakenCells(some: List<Judgement>): List<Any> {
        val (shaders, kotlin) = some.partition { judgement -> Corpus.edits(Corpus.byName(judgement.name)).any { it.isShader } }
        return listOf(Answer.NAMED, Answer.WRONG, Answer.UNKNOWN, Answer.MISSED).map { answer -> some.count { it.answer == answer } } +
            listOf(some.count { it.elsewhere.isNotEmpty() }, near(some)) + listOf(shaders, kotlin).map(::lines)
    }

    private fun unfinishedCells(some: List<Judgement>) = listOf(near(some), some.count { it.answer == Answer.WRONG })

    private fun near(some: List<Judgement>) = some.count { abs(it.points - it.wanted) <= Answered.NEAR }

    private fun lines(some: List<Judgement>) = "${some.count { it.line == true }} of ${some.size}"

    private const val HEAD_CORRECT = "| correct submissions | judged | full points | false positives |\n|---|--:|--:|--:|\n"
    private const val HEAD_MISTAKEN =
        "| mistaken submissions | judged | named | wrong name | unknown | missed | points lost elsewhere | points within 5 | " +
            "lines right in shaders | in Kotlin |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n"
    private const val HEAD_UNFINISHED = "| unfinished submissions | judged | points within 5 | wrong name |\n|---|--:|--:|--:|\n"
}
