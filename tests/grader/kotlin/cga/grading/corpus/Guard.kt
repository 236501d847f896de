package cga.grading.corpus

import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.testing.projectRoot
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import kotlin.io.path.writeText

/** Judges submissions of the corpus, by captures kept in `build/corpus`, and compares with what the grader said when that was checked in. */
internal object Guard {
    /** What was said of each, by name. */
    val expectations: Path = projectRoot.toPath().resolve("tests/submissions/judged.csv")

    /** Where it leaves what it says: a page over all, and all that it says of each. */
    val reports: Path = projectRoot.toPath().resolve("build/corpus")

    /** What was said now, and in which way it is worse; both by name. */
    class Report(
        val judged: Map<String, Judgement>,
        val worse: Map<String, String>,
    )

    /**
     * A submission for every mistake that is ever expected, those held out first, and for every [CORRECT_EACH] of these a correct one: each
     * mistake is guarded, and with as few as possible.
     */
    fun chosen(): List<Submission> {
        val missing = Corpus.all.flatMap { it.expectation.mistakes.flatten() }.toMutableSet()
        val mistaken = (Corpus.heldOut + Corpus.mistaken).filter { missing.removeAll(it.expectation.mistakes.flatten().toSet()) }
        val unfinished = Corpus.all.filter { it.expectation.points != null }
        // Rewrites of one kind stand side by side in their files.
        val correct = Corpus.correct.sortedBy { it.name.hashCode() }.take(mistaken.size / CORRECT_EACH)
        return mistaken + unfinished + correct
    }

    /** Judges [some], and tells [listener] each. What this grader has said already is not judged again. */
    fun judge(some: List<Submission>, listener: (Judgement) -> Unit = {}): Report {
        val expected = Judgement.read(expectations)
        val judged = LinkedHashMap<String, Judgement>()
        val said = SaidAlready(reports)
        CorpusCaptures().use { captures ->
            // A run of a submission uses half of a processor; judging begins when the first has ended.
            val runs = Executors.newFixedThreadPool(RUNS)
            try {
                val known = some.associateWith { said.of(captures.file(it)) }
                val files = some.filter { known[it] == null }.associateWith { runs.submit(Callable { captures.of(it) }) }
                for (submission in some) {
                    val judgement = known[submission] ?: judge(submission, files.getValue(submission).get(), said)
                    judged[submission.name] = judgement
                    listener(judgement)
                }
            } finally {
                runs.shutdownNow()
            }
        }
        val worse = judged.mapNotNull { (name, now) -> expected[name]?.let(now::worseThan)?.let { name to it } }
        return Report(judged, worse.toMap())
    }

    private fun judge(
        submission: Submission,
        capture: Path,
        said: SaidAlready,
    ): Judgement {
        val answered = OffscreenContext.open(ContextKind.OSMESA).use { Answered.of(submission, capture) }
        reports.resolve("${submission.name}.txt").writeText(answered.details.joinToString("\n", postfix = "\n"))
        return Judgement.of(answered).also { said.note(capture, it) }
    }

    private const val CORRECT_EACH = 3
    const val RUNS = 2
}
