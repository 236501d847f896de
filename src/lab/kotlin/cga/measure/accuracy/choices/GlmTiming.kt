package cga.measure.accuracy.choices

import cga.framework.Home
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createTempDirectory

/** GLM's times, by a C++ program that is compiled here. Null where there is no compiler or no GLM: it is a comparison, not a need. */
internal class GlmTiming private constructor(private val folder: Path) : AutoCloseable {
    /** Nanoseconds by operation and precision, as in "placing;float". */
    fun measure(): Map<String, Double> =
        linesOf(listOf("${folder.resolve(PROGRAM)}"))
            .orEmpty()
            .associate { it.substringBeforeLast(';') to it.substringAfterLast(';').toDouble() }

    override fun close() {
        folder.toFile().deleteRecursively()
    }

    companion object {
        private const val PROGRAM = "timing"

        fun orNull(): GlmTiming? {
            val source = Home.resolve("tests/glm/timing.cpp")
            if (!Files.exists(source)) return null
            val folder = createTempDirectory("cga-glm")
            val compiled = linesOf(listOf("g++", "-std=c++17", "-O3", "-ffp-contract=off", "-o", "${folder.resolve(PROGRAM)}", "$source"))
            if (compiled != null) return GlmTiming(folder)
            folder.toFile().deleteRecursively()
            return null
        }

        /** What [command] prints, or null where it is not there or fails. */
        private fun linesOf(command: List<String>): List<String>? =
            try {
                val process = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start()
                val lines = process.inputReader().readLines()
                lines.takeIf { process.waitFor() == 0 }
            } catch (_: IOException) {
                null
            }
    }
}
