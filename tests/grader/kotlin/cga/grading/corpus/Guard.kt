package cga.grading.corpus

import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.testing.projectRoot
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.Executors

/** Judges submissions of the corpus, by captures kept in `build/corpus`, and compares with what the grader said when that was checked in. */
internal object Guard {
    /** What was said of each, by name. */
    val expectations: Path = projectRoot.toPath().resolve("tests/submissions/judged.csv")

    /** What was said now, and in which way it is worse; both by name. */
    class Report(
        val judged: Map<String, Judgement>,
        val worse: Map<String, String>,
        val details: Map<String, List<String>>,
    )

    /**
     * A submission for every mistake that is ever expected, those held out first, and for every [CORRECT_EACH] of these a correct one: each
     * mistake is guarded, and with as few as possible.
     */
    fun chosen(): List<Submission> {
        val missing = Corpus.all.flatMap { it.expectation.mistakes.flatten() }.toMutableSet()
        val mistaken = (Corpus.heldOut + Corpus.mistaken).filter { missing.removeAll(it.expectation.mistakes.flatten().toSet()) }
        // Rewrites of one kind stand side by side in their files.
        val correct = Corpus.correct.sortedBy { it.name.hashCode() }.take(mistaken.size / CORRECT_EACH)
        return mistaken + correct
    }

    /** Judges [some], and tells [listener] each. */
    fun judge(some: List<Submission>, listener: (Judgement) -> Unit = {}): Report {
        val captures = CorpusCaptures()
        val expected = Judgement.read(expectations)
        val judged = LinkedHashMap<String, Judgement>()
        val details = LinkedHashMap<String, List<String>>()
        val worse = LinkedHashMap<String, String>()
        // A run of a submission uses half of a processor; judging begins when the first has ended.
        val runs = Executors.newFixedThreadPool(RUNS)
        try {
            val files = some.map { submission -> runs.submit(Callable { captures.of(submission) }) }
            for ((submission, file) in some.zip(files)) {
                val answered = OffscreenContext.open(ContextKind.OSMESA).use { Answered.of(submission, file.get()) }
                val judgement = Judgement.of(answered)
                judged[submission.name] = judgement
                details[submission.name] = answered.details
                expected[submission.name]?.let(judgement::worseThan)?.let { worse[submission.name] = it }
                listener(judgement)
            }
        } finally {
            runs.shutdownNow()
            captures.close()
        }
        return Report(judged, worse, details)
    }

    private const val CORRECT_EACH = 3
    const val RUNS = 2
}
