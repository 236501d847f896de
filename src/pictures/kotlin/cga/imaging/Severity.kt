package cga.imaging

/** How a compare ended, from good to bad. */
public enum class Severity {
    PASS,

    /** Within what is allowed, but worth a look. */
    WARN,

    FAIL,
}
