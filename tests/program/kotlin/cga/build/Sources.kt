package cga.build

import cga.testing.projectRoot
import java.io.File

/** The Kotlin files below these folders, as paths relative to the project, in one order on every machine. */
internal fun kotlinFiles(vararg folders: String): List<File> =
    folders
        .flatMap { projectRoot.resolve(it).walk() }
        .filter { it.isFile && it.extension == "kt" }
        .map { it.relativeTo(projectRoot) }
        .sortedBy { it.invariantSeparatorsPath }
