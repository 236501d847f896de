package cga.grading.rubric

import cga.grading.findings.Check
import cga.grading.findings.Message
import cga.grading.findings.Mistake

/** How a check stands. */
public enum class CheckState(
    public val id: String,
) {
    /** Within the tolerance. */
    RIGHT("right"),

    /** A mistake with a name, which belongs here, costs it. */
    MISTAKE("mistake"),

    /** Beyond the tolerance, and nothing with a name explains it. */
    INEXACT("inexact"),

    /** It differs because of a mistake that has been charged elsewhere, so it keeps its points. */
    EXPLAINED("explained"),

    /** The submission has nothing there. */
    NOT_FOUND("not-found"),

    /** It could not be measured: a person has to look. It has no points yet, which is not the same as 0. */
    OPEN("open"),
}

/**
 * The points of one check.
 *
 * @param maximum what it is worth.
 * @param points what it earned, in tenths; null while it is [CheckState.OPEN].
 * @param cause the mistake that costs it ([CheckState.MISTAKE]) or that explains it ([CheckState.EXPLAINED]).
 * @param message the figures behind it.
 */
public class CheckGrade(
    public val check: Check,
    public val state: CheckState,
    public val maximum: Double,
    public val points: Double?,
    public val error: Double?,
    public val cause: Mistake?,
    public val message: Message,
)

/** The points of one task of the sheet. */
public class TaskGrade(
    public val task: String,
    public val checks: List<CheckGrade>,
) {
    public val maximum: Double get() = checks.sumOf { it.maximum }
    public val points: Double get() = checks.sumOf { it.points ?: 0.0 }

    /** Points that a person has yet to give or to refuse. */
    public val open: Double get() = checks.filter { it.points == null }.sumOf { it.maximum }
}
