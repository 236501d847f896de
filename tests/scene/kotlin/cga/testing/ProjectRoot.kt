package cga.testing

import java.io.File
import java.nio.file.Path

/** The project's folder: both builds start the tests there. */
val projectRoot: File = File("").absoluteFile

/** What test runs keep for later ones. */
val testingFolder: Path = projectRoot.resolve("build/testing").toPath()
