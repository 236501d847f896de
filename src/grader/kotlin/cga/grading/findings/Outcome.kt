package cga.grading.findings

/** How it ended with one submission: measured, or refused with the reason. */
public sealed interface Outcome {
    public val facts: RunFacts
}

/** It was run and measured. The pictures that [findings] name lie in the folder that the grader was given. */
public class Graded(
    public val findings: Findings,
    override val facts: RunFacts = RunFacts(),
) : Outcome

/**
 * It could not be measured.
 *
 * @param detail what exactly happened, one or a few lines; it may quote the submission.
 */
public class Refused(
    public val reason: FailureReason,
    public val detail: String,
    override val facts: RunFacts = RunFacts(),
) : Outcome

/**
 * How a submission was run.
 *
 * @param kind "starter" or "course".
 * @param edition of the course, as detected or asked for.
 * @param compiler which compiler and language level its Kotlin went through.
 * @param seconds wall time of each stage, by the stage's name, in order.
 * @param isConfined false where it ran without a sandbox, so that it could have changed its own result.
 * @param likeness what it is compared with others by.
 * @param peakBytes most memory that its whole process tree held at once.
 */
public class RunFacts(
    public val kind: String? = null,
    public val edition: String? = null,
    public val compiler: String? = null,
    public val seconds: Map<String, Double> = emptyMap(),
    public val peakBytes: Long? = null,
    public val logs: List<LogExcerpt> = emptyList(),
    public val isConfined: Boolean = true,
    public val likeness: Likeness = Likeness(),
)

/** A part of what a stage said; it may hold anything that the submission wrote. */
public class LogExcerpt(
    public val title: String,
    public val text: String,
)
