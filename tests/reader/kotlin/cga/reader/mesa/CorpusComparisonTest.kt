package cga.reader.mesa

import cga.reader.Reading
import cga.reader.shader.Stage
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
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
        val notRead = ArrayList<String>()
        val refused = ArrayList<String>()
        val shaders = shaders()
        for (file in shaders) {
            val name = file.relativeTo(projectRoot).invariantSeparatorsPath
            val text = expanded(file)
            val stage = if (file.name.contains("vert")) Stage.VERTEX else Stage.FRAGMENT
            val reading = Reading.of(name, text, stage)
            if (reading !is Reading.Done) {
                notRead += (reading as Reading.Failed).problems.toString()
                continue
            }
            try {
                val compare = if (stage == Stage.VERTEX) ::compareVertices else ::compareFragments
                val c = compare(name, text, reading.shader, POINTS, Random(1))
                println("$name $c")
                all += c
            } catch (e: Refused) {
                refused += "$name: ${e.message}"
            } catch (e: IllegalStateException) {
                refused += "$name: ${e.message}"
            }
        }
        println("${shaders.size} shaders, ${notRead.size} not read, ${refused.size} refused by the driver: $all")
        notRead.forEach(::println)
        refused.forEach(::println)
        all.wrong.take(40).forEach(::println)
        assertEquals(emptyList<String>(), all.wrong.take(10))
    }

    private fun shaders(): List<File> =
        listOf("tests/submissions", "shaders").flatMap { projectRoot.resolve(it).walk() }
            .filter { it.extension in setOf("glsl", "vert", "frag") && (it.extension != "glsl" || '_' in it.name) }.sorted()

    /** One program of the corpus puts its shaders together itself. */
    private fun expanded(file: File): String =
        file.readLines().joinToString("\n") { line ->
            if (line.startsWith("//#include ")) expanded(file.resolveSibling(line.substringAfter(' ').trim())) else line
        }

    private companion object {
        const val POINTS = 24
    }
}
