package cga.grading.corpus

import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.writeText

/**
 * The Kotlin of the corpus compiles: of the project itself, and of a mixture with much in it. With `-Dcga.corpus=all` that of every
 * submission, which takes some minutes.
 */
@Slow
internal class CorpusCompileTest {
    @ParameterizedTest
    @MethodSource("chosen")
    fun `it compiles`(
        submissions: List<Submission>,
        @TempDir folder: Path,
    ) {
        val sources = folder.resolve("src").createDirectories()
        for ((path, text) in Corpus.sources(submissions.first()).filterKeys { it.endsWith(".kt") }) {
            sources.resolve(path).apply { parent.createDirectories() }.writeText(text)
        }
        assertEquals("", Compiled.complaints(listOf(sources), folder.resolve("out")), "$submissions")
        assertTrue(folder.resolve("out/cga/exercise/MainKt.class").exists())
    }

    @Test
    fun `what is wrong is reported`(
        @TempDir folder: Path,
    ) {
        folder.resolve("Wrong.kt").writeText("val x: Int = \"\"\n")
        assertTrue("Wrong.kt:1:" in Compiled.complaints(listOf(folder), folder.resolve("out")))
    }

    @Test
    fun `a submission has its models and textures beside the shaders`(
        @TempDir folder: Path,
    ) {
        val nested = Corpus.correct.first { "nested-deeply" in it.rewrites }
        Corpus.materialize(nested, folder)
        val assets = folder.resolve("Abgabe Gruppe 7/tron/assets")
        val names = listOf("shaders/tron_vert.glsl", "models/ground.obj", "models/motorcycle/motorcycle.mtl", "textures/ground_emit.png")
        assertEquals(names, names.filter { assets.resolve(it).exists() })
    }

    private companion object {
        /** Submissions whose Kotlin is the same, for their shaders differ only, are compiled once. */
        @JvmStatic
        fun chosen(): List<List<Submission>> {
            val isAll = System.getProperty("cga.corpus") == "all"
            val some = Corpus.all.filter { isAll || it.name in listOf("plain", "later", "mix-001") }
            return some.groupBy { submission -> Corpus.sources(submission).filterKeys { it.endsWith(".kt") } }.values.toList()
        }
    }
}
