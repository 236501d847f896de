package cga.grading.course

import cga.grading.findings.Measured
import cga.grading.findings.Outcome
import java.nio.file.Path

/** Finds out what one submission does: unpack, compile, run, measure. Several threads call it at once, each with another submission. */
public fun interface GradeOne : AutoCloseable {
    /**
     * Grades the folder or archive [submission], which it does not change.
     *
     * @param folder empty; the pictures that the findings name are left in it. Anything else in it is removed afterwards.
     * @param listener told of each check as soon as it has been measured.
     * @return how it ended. What is the submission's own fault is a [cga.grading.findings.Refused], never an exception; an exception is
     *   reported as a failure of the grader and costs only this submission.
     */
    public fun grade(submission: Path, folder: Path, listener: CheckListener): Outcome

    /** Ends what is kept from one submission to the next; to be called when no submission is being graded any more. */
    override fun close() {}
}

/** Hears of each check as soon as it has been measured. */
public fun interface CheckListener {
    public fun measured(check: Measured)
}
