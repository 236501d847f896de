package cga.framework

/**
 * Something that the user gave cannot be used: a file, a value, a machine without OpenGL.
 *
 * The message is all the user sees (exit code 2, no stack trace), so it names the file or the value, and the cure.
 */
public open class InputError(message: String, cause: Throwable? = null) : RuntimeException(message, cause)
