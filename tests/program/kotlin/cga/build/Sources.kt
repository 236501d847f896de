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

/** The parts of the program, each a folder of `src`, and the packages below `cga` that lie there. */
internal val PACKAGES: Map<String, Set<String>> =
    mapOf(
        "scene" to setOf("framework", "exercise"),
        "reader" to setOf("reader"),
        "pictures" to setOf("imaging", "reference"),
        "cli" to setOf("cli"),
        "window" to setOf("coach", "inspect", "cli.window"),
        "grader" to setOf("grading", "cli.grader"),
        "lab" to setOf("measure", "cli.lab"),
    )
internal val PARTS: Set<String> = PACKAGES.keys
