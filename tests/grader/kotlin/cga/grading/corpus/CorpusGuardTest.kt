package cga.grading.corpus

import cga.testing.Need
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The grader says of the corpus what it said before. In every run of the tests of a few submissions; `./cga corpus` judges more of them:
 * `CGA_CORPUS` is `guard` for one of every mistake, `all`, `I/N` for a part of these, or names.
 */
@Slow
class CorpusGuardTest {
    private val accepts = System.getenv("CGA_CORPUS_ACCEPT") == "true"

    @Test
    fun `nothing is judged worse than before`() {
        Offscreen.openOrSkip().close()
        val some = chosen(System.getenv("CGA_CORPUS") ?: "")
        val report = Guard.judge(some) { println("corpus: ${it.name}: ${it.answer.name.lowercase()}, ${it.points} points") }
        if (accepts) Judgement.write(Guard.expectations, Judgement.read(Guard.expectations) + report.judged)
        write(report)
        if (!accepts) assertEquals("", report.worse.entries.joinToString("\n") { (name, how) -> "$name: $how" })
    }

    @Test
    fun `what is worse is told from what is better`() {
        val before = Judgement("a", Answer.UNKNOWN, 90.0, setOf("4.2.normals"), 95.0, true)
        assertNull(before.copy(answer = Answer.NAMED).worseThan(before))
        assertNull(before.copy(elsewhere = emptySet()).worseThan(before))
        assertNotNull(before.copy(answer = Answer.MISSED).worseThan(before))
        assertNotNull(before.copy(elsewhere = setOf("4.2.normals", "4.3.cone")).worseThan(before))
        assertNull(before.copy(points = 94.0).worseThan(before))
        assertNotNull(before.copy(points = 89.0).worseThan(before))
        assertNotNull(before.copy(points = 100.5).worseThan(before))
        assertNotNull(before.copy(line = false).worseThan(before))
        assertNotNull(before.copy(line = null).worseThan(before))
        assertNull(before.worseThan(before.copy(line = false)))
    }

    @Test
    fun `every mistake is guarded`() {
        val expected = Corpus.all.flatMap { it.expectation.mistakes.flatten() }.toSet()
        assertEquals(emptySet<Any>(), expected - Guard.chosen().flatMap { it.expectation.mistakes.flatten() }.toSet())
    }

    @Test
    fun `more work never earns less, and none earns next to nothing`() {
        val judged = Judgement.read(Guard.expectations)
        val points = listOf("starter-untouched", "solved-all").map { judged.getValue(it).points }
        assertTrue(points.first() <= 2 && judged.getValue("starter-one-line").points <= 2)
        assertEquals(100.0, points.last())
    }

    @Test
    fun `docs-grading tells what is checked in`() {
        val table = projectRoot.resolve("docs/grading.md").readText().substringAfter("$MARKER\n").substringBefore("\n<!-- end -->")
        assertEquals(ConfusionTable.of(Judgement.read(Guard.expectations)), table)
    }

    private fun chosen(what: String): List<Submission> {
        val part = Regex("(\\d+)/(\\d+)").matchEntire(what)
        return when {
            what.isEmpty() -> Guard.chosen().filterIndexed { i, _ -> i % EVERY == 0 }
            what == "guard" -> Guard.chosen()
            what == "all" -> Corpus.all
            part != null -> part.destructured.let { (i, n) -> Corpus.all.filterIndexed { k, _ -> k % n.toInt() == i.toInt() - 1 } }
            else -> what.split(' ').map(Corpus::byName)
        }
    }

    private fun write(report: Guard.Report) {
        val judged = Judgement.read(Guard.expectations) + report.judged
        Guard.reports.resolve("report.md").writeText(ConfusionTable.of(if (accepts) judged else report.judged) + "\n")
        if (!accepts) return
        val page = projectRoot.toPath().resolve("docs/grading.md")
        val text = page.readText()
        val old = text.substringAfter("$MARKER\n").substringBefore("\n<!-- end -->")
        page.writeText(text.replace("$MARKER\n$old\n<!-- end -->", "$MARKER\n${ConfusionTable.of(judged)}\n<!-- end -->"))
    }

    private companion object {
        const val MARKER = "<!-- table:corpus -->"

        /** Four of them in every run of the tests: each takes ten seconds. */
        const val EVERY = 17
    }
}
