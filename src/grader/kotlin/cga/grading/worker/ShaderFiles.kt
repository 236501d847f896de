package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedProgram
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.Path

/** Which files shaders were read from: those that have the same lines in the same places, but for what was put in between or repaired. */
internal class ShaderFiles(private val folder: Path) {
    private val files: Map<String, List<String>> by lazy {
        paths().associate {
            "${folder.relativize(it)}" to
                lines(Files.readAllBytes(it).decodeToString())
        }
    }

    /** [program] with the files below the folder that its sources are in. */
    fun named(program: CapturedProgram): CapturedProgram = program.inFiles(file(program.vertexSource), file(program.fragmentSource))

    private fun file(source: String): String? {
        val wanted = lines(source)
        val (file, likeness) = files.mapValues { likeness(it.value, wanted) }.maxByOrNull { it.value } ?: return null
        return file.takeIf { likeness > LEAST_ALIKE && it.length <= CaptureLimits.NAME }
    }

    /** The share of the lines that stand in the same place in both. */
    private fun likeness(
        a: List<String>,
        b: List<String>,
    ): Double {
        val all = maxOf(a.size, b.size)
        val different = (0 until all).count { a.getOrNull(it) != b.getOrNull(it) }
        return 1 - different / all.toDouble()
    }

    private fun lines(text: String) = text.trimEnd().lines().map(String::trimEnd)

    private fun paths(): List<Path> =
        Files.walk(folder, DEPTH).use { all ->
            all
                .limit(MOST_FILES)
                .filter { SHADER.containsMatchIn("${it.fileName}") && Files.isRegularFile(it, LinkOption.NOFOLLOW_LINKS) }
                .filter { Files.size(it) < CaptureLimits.SOURCE }
                .limit(MOST_SHADERS)
                .toList()
        }

    private companion object {
        /** Half of the lines are of an included file, or of a stand-in. */
        const val LEAST_ALIKE = 0.5
        const val DEPTH = 8
        const val MOST_FILES = 4000L
        const val MOST_SHADERS = 64L
        val SHADER = Regex("""\.(glsl|vert|frag|vs|fs|vsh|fsh|vertex|fragment|shader|txt)$""", RegexOption.IGNORE_CASE)
    }
}
