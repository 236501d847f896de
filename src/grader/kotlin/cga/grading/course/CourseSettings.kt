package cga.grading.course

import cga.grading.report.Language
import cga.grading.rubric.Rubric
import java.nio.file.Path

/**
 * How a course is graded.
 *
 * @param edition of the course, null where each submission's is detected. What was measured for one is not taken for another.
 * @param jobs how many submissions are graded at the same time.
 * @param gradescope where Gradescope's results of a single submission go besides its folder, after every check.
 */
public class CourseSettings(
    public val rubric: Rubric,
    public val language: Language,
    public val edition: String? = null,
    public val jobs: Int = 1,
    public val gradescope: Path? = null,
) {
    init {
        require(jobs >= 1) { "$jobs jobs grade nothing" }
    }

    /** What a measurement depends on besides its input; points and pages depend on more, and are made anew without measuring. */
    internal val fingerprint: String get() = "edition ${edition ?: "detected"}"
}
