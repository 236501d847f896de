package cga.grading.corpus

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.io.path.writeText

/** The corpus is whole. With `-Dcga.corpus=fix` the list of correct submissions is made anew. */
@Slow
class CorpusTest {
    private val combinations = Combinations(Corpus.rewrites.values.toList())

    init {
        if (System.getProperty("cga.corpus") == "fix") Corpus.correctList.writeText(correctList())
    }

    @Test
    fun `every edit of every submission applies, and just once`() {
        val failures = sources.mapNotNull { (_, sources) -> sources.exceptionOrNull()?.message }
        assertEquals("", failures.joinToString("\n"), "${failures.size} of ${Corpus.all.size} submissions")
    }

    @Test
    fun `any two rewrites that go together are together in a correct submission`() {
        val covered = Corpus.listed.flatMap { combinations.pairsOf(it.rewrites) }.toSet()
        assertEquals(emptyList<Any>(), combinations.pairs.filter { it !in covered })
    }

    @Test
    fun `only rewrites that go together are together`() {
        for (submission in Corpus.listed) {
            val strangers = combinations.pairsOf(submission.rewrites).filter { it !in combinations.pairs }
            assertEquals(emptyList<Any>(), strangers, submission.name)
        }
    }

    @Test
    fun `no two submissions are the same`() {
        val same = sources.filter { it.second.isSuccess }.groupBy({ it.second.toString() }, { it.first }).values.filter { it.size > 1 }
        assertEquals(emptyList<Any>(), same)
    }

    @Test
    fun `there are 100 correct submissions and 40 mistaken ones`() {
        assertTrue(Corpus.correct.size >= 100) { "${Corpus.correct.size}" }
        assertTrue(Corpus.mistaken.size >= 40) { "${Corpus.mistaken.size}" }
        assertTrue(Corpus.mistaken.all { it.expectation.mistakes.isNotEmpty() && it.expectation.costs.isNotEmpty() })
    }

    @Test
    fun `there are 30 mistaken submissions held out, of 25 mistakes and every task, some with two`() {
        val expected = Corpus.heldOut.map { it.expectation }
        assertTrue(expected.size >= 30) { "${expected.size}" }
        assertTrue(expected.count { it.mistakes.size > 1 } >= 8)
        assertTrue(expected.all { it.mistakes.isNotEmpty() && it.costs.isNotEmpty() })
        val made = expected.flatMap { it.mistakes.flatten() }.toSet()
        assertTrue(made.size >= 25) { "${made.size}" }
        assertEquals(Check.entries.map { it.task }.toSet(), expected.flatMap { it.tasks }.map { it.take(TASK) }.toSet())
    }

    @Test
    fun `every name is that of one rewrite, mistake or submission`() {
        val names = Corpus.all.map { it.name }
        assertEquals(names.distinct(), names)
        val twice = (Corpus.mistaken + Corpus.heldOut).map { it.name }.filter { it in Corpus.rewrites }
        assertEquals(emptyList<String>(), twice)
    }

    @Test
    fun `every mistake with a name is made by a submission`() {
        val made = Corpus.mistaken.flatMap { it.expectation.mistakes.flatten() }.toSet()
        // All members compile; those that do not are RepairTest's.
        assertEquals(emptyList<Mistake>(), Mistake.entries - made - Mistake.UNKNOWN - Mistake.KOTLIN_REFUSED)
    }

    @Test
    fun `every cost is that of a check`() {
        val costs = (Corpus.mistaken + Corpus.heldOut).flatMap { it.expectation.costs }.toSet()
        assertEquals(emptySet<String>(), costs - Check.entries.map { it.id }.toSet())
    }

    private fun correctList(): String {
        val alone = Corpus.rewrites.values.map { rewrite ->
            rewrite.name to
                Corpus.rewrites.keys.filter { it == rewrite.name || it in rewrite.with }
        }
        val mixed = combinations.choose(SIZE, SEED).mapIndexed { i, names -> "mix-%03d".format(i + 1) to names }
        val lines = (listOf("plain" to emptyList<String>()) + alone + mixed).map { (name, parts) ->
            "$name: ${parts.joinToString(" ")}".trim()
        }
        return HEAD + lines.joinToString("\n") + "\n"
    }

    private companion object {
        /** Every submission, with its files or why it has none; that takes seconds. */
        val sources: List<Pair<Submission, Result<Sources>>> by lazy { Corpus.all.map { it to runCatching { Corpus.sources(it) } } }

        const val SIZE = 14
        const val SEED = 4

        /** Length of `4.2`. */
        const val TASK = 3
        const val HEAD =
            "# Submissions without a mistake, by their rewrites: none, each alone, and mixtures in which any two that go together meet.\n" +
                "# Made by running CorpusTest with -Dcga.corpus=fix.\n"
    }
}
