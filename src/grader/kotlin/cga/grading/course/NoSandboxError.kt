package cga.grading.course

import cga.framework.InputError

/** There is no sandbox on this machine, and doing without was not allowed. The message says what to install or to type. */
public class NoSandboxError(message: String) : InputError(message)
