package cga.grading.sandbox

/** How a [Job] ended. */
public sealed interface End {
    /** It ended by itself. */
    public data class Exited(
        public val code: Int,
    ) : End

    /**
     * A signal ended it: 6 and 11 are native crashes. A program that exits with 128 + n by itself looks the same.
     */
    public data class Signalled(
        public val signal: Int,
    ) : End

    /** It went past a limit and was killed. */
    public data class Exceeded(
        public val limit: Limit,
    ) : End
}

/** The entries of [Limits]. */
public enum class Limit { WALL_CLOCK, CPU, MEMORY, PROCESSES, OUTPUT, DISK }

/**
 * What became of a [Job]. When there is one, no process of the job is alive any more.
 *
 * @param output the beginning of standard output, [errors] of standard error, as far as [Limits.keptBytes] goes.
 * @param wallSeconds from start to end.
 * @param cpuSeconds of the whole tree, as last seen: up to a twentieth of a second a processor may be missing.
 * @param peakMemoryBytes the largest resident memory of the whole tree that was seen.
 */
public class Outcome(
    public val end: End,
    public val output: String,
    public val errors: String,
    public val wallSeconds: Double,
    public val cpuSeconds: Double,
    public val peakMemoryBytes: Long,
) {
    /** It ended by itself with exit code 0. */
    public val isSuccess: Boolean get() = end == End.Exited(0)
}
