package cga.reader.run

/** How an invocation ended. */
public enum class Outcome {
    /** At the end of `main`. */
    DONE,

    /** By `discard`: no output counts. */
    DISCARDED,

    /** It took more steps than it was given: an endless loop, or nearly. */
    TOO_LONG,

    /** A texture that no [Sampler] was given for is looked into. */
    NO_SAMPLER,
}
