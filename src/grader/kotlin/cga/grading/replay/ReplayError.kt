package cga.grading.replay

/** A captured frame cannot be drawn again: its GLSL does not compile here, or OpenGL refuses something; the message says what. */
public class ReplayError(message: String) : RuntimeException(message)
