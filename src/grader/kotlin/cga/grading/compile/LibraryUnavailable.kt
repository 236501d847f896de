package cga.grading.compile

import cga.framework.InputError

/**
 * A library that cannot be had; the message says why.
 *
 * @param isUnknown the repository answered, and has no such library.
 */
public class LibraryUnavailable(
    message: String,
    public val isUnknown: Boolean = false,
    cause: Throwable? = null,
) : InputError(message, cause)
