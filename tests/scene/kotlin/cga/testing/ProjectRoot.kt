package cga.testing

import java.io.File

/** The project's folder: both builds start the tests there. */
val projectRoot: File = File("").absoluteFile
