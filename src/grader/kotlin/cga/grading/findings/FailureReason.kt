package cga.grading.findings

/**
 * Why a submission could not be measured. The words for the reader are in the message files, under the same [id].
 *
 * @param isItsOwn whether the submission is to blame: then it has 0 points, else none yet.
 */
public enum class FailureReason(
    public val id: String,
    public val isItsOwn: Boolean,
) {
    NOT_RECOGNIZED("not-recognised", true),
    UNPACK_REFUSED("unpack-refused", true),
    DOES_NOT_COMPILE("does-not-compile", true),
    EXCEPTION("exception", true),
    CRASHED("crashed", true),
    EXITED("exited", true),
    TIMED_OUT("timed-out", true),
    OUT_OF_MEMORY("out-of-memory", true),
    TOO_MUCH_OUTPUT("too-much-output", true),
    TOO_MANY_PROCESSES("too-many-processes", true),
    NOTHING_DRAWN("nothing-drawn", true),
    CAPTURE_UNREADABLE("capture-unreadable", true),
    NOT_REPRODUCIBLE("not-reproducible", true),

    /** What to grade is not there or cannot be read. */
    MISSING("missing", false),

    /** There is no sandbox, and none was not allowed. */
    NO_SANDBOX("no-sandbox", false),

    /** A compiler or a library could not be had. */
    NO_COMPILER("no-compiler", false),

    /** The grader itself failed. */
    INTERNAL("internal", false),
}
