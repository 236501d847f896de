package cga.grading.pipeline

import cga.grading.findings.FailureReason
import cga.grading.findings.Findings
import cga.grading.findings.Graded
import cga.grading.findings.Likeness
import cga.grading.findings.LogExcerpt
import cga.grading.findings.Message
import cga.grading.findings.Part
import cga.grading.findings.Refused
import cga.grading.findings.RunFacts
import cga.grading.sandbox.Outcome

/** What is noted about one submission on its way through the steps. */
internal class Run(
    private val isConfined: Boolean = true,
) {
    /** What there is to compare it with. */
    var solution: Likeness = Likeness()
    private val keys = LinkedHashMap<Part, String>()

    var kind: String? = null
    var edition: String? = null
    var compiler: String? = null
    private val seconds = LinkedHashMap<String, Double>()
    private var peakBytes = 0L
    private val logs = mutableListOf<LogExcerpt>()

    /** Runs [step] and notes how long it took, also when it fails. */
    fun <T> timed(name: String, step: () -> T): T {
        val start = System.nanoTime()
        try {
            return step()
        } finally {
            seconds[name] = (System.nanoTime() - start) / 1e9
        }
    }

    /** Notes the keys of its parts. */
    fun compare(keys: Map<Part, String>) {
        this.keys += keys
    }

    fun likeness(): Likeness = Likeness(keys.toMap()).let { Likeness(it.keys, it.shared(solution)) }

    /** Notes what [outcome] of the job [title] took and said. */
    fun note(title: String, outcome: Outcome) {
        peakBytes = maxOf(peakBytes, outcome.peakMemoryBytes)
        log(title, listOf(outcome.output, outcome.errors).filter(String::isNotBlank).joinToString("\n"))
    }

    fun log(title: String, text: String) {
        if (text.isNotBlank()) logs += LogExcerpt(title, text.take(MOST_LOG))
    }

    fun graded(findings: Findings, notes: List<String>): Graded =
        Graded(
            Findings(
                findings.checks,
                findings.mistakes,
                findings.plots,
                findings.pictures,
                (notes.map(Message::plain) + findings.notes).distinct(),
                findings.proof,
            ),
            facts(),
        )

    fun refused(reason: FailureReason, detail: String): Refused = Refused(reason, detail, facts())

    private fun facts() =
        RunFacts(kind, edition, compiler, seconds.toMap(), peakBytes.takeIf { it > 0 }, logs.toList(), isConfined, likeness())

    private companion object {
        const val MOST_LOG = 20_000
    }
}
