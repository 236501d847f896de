package cga.exercise.components.shader

import cga.framework.InputError

/** GLSL that does not compile or link; the message names file and line and shows the offending source line. */
public class ShaderError(message: String) : InputError(message)
