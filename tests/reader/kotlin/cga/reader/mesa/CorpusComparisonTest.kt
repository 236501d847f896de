package cga.reader.mesa

import cga.exercise.components.shader.ShaderSource
import cga.reader.shader
import cga.reader.shader.Stage
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*
import java.io.File
import kotlin.random.Random

/** What is read of every shader of the corpus and of our own is what Mesa draws with it, as nearly as floats can be. */
@Slow
@ExtendWith(Offscreen::class)
class CorpusComparisonTest {
    @Test
    fun `every shader computes what Mesa draws`() {
        glBindVertexArray(glGenVertexArrays())
        val all = Comparison()
        val shaders = shaders()
        for (file in shaders) {
            val name = file.relativeTo(projectRoot).invariantSeparatorsPath
            val stage = if ("vert" in file.name) Stage.VERTEX else Stage.FRAGMENT
            val text = expanded(file)
            val compare = if (stage == Stage.VERTEX) ::compareVertices else ::compareFragments
            val compared = compare(name, text, shader(text, stage, name), POINTS, Random(1))
            // Half of what is computed can be told at least, or the numbers given are no good.
            assertTrue(compared.numbers >= compared.open) { "$name: $compared" }
            all += compared
        }
        println("${shaders.size} shaders: $all")
        assertEquals(emptyList<String>(), all.wrong)
        assertTrue(shaders.size > 190 && all.numbers > 50_000) { "${shaders.size} shaders: $all" }
    }

    private fun shaders(): List<File> =
        listOf("tests/submissions", "shaders")
            .flatMap { projectRoot.resolve(it).walk() }
            .filter { it.extension in setOf("vert", "frag") || (it.extension == "glsl" && '_' in it.name) }
            .sorted()

    /** One program of the corpus puts its shaders together itself. */
    private fun expanded(file: File): String =
        ShaderSource.read("$file").text.lines().joinToString("\n") { line ->
            if (line.startsWith("//#include ")) expanded(file.resolveSibling(line.substringAfter(' ').trim())) else line
        }

    private companion object {
        const val POINTS = 24
    }
}
