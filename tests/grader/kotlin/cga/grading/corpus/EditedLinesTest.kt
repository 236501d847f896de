package cga.grading.corpus

import cga.grading.findings.Place
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.TreeMap

class EditedLinesTest {
    private fun sources(lines: List<Int>) = TreeMap(mapOf("src/a/Scene.kt" to lines.joinToString("\n"), "b.glsl" to "same"))

    private fun between(after: List<Int>) = EditedLines.between(sources((1..20).toList()), sources(after)).map { it.lines }

    @Test
    fun `lines that are changed, added and taken away are told where they are afterwards`() {
        assertEquals(listOf(5..5, 9..9), between((1..20).map { if (it == 5 || it == 9) -it else it }))
        assertEquals(listOf(5..6), between((1..4) + listOf(50, 60) + (5..20)))
        assertEquals(listOf(5..5), between((1..4) + (8..20)))
        assertEquals(emptyList<IntRange>(), between((1..20).toList()))
    }

    @Test
    fun `a place is right within three lines, in the file by the end of its path`() {
        val edited = EditedLines("src/main/kotlin/game/Scene.kt", 10..11)
        for (line in listOf(7, 10, 14)) assertTrue(edited.isAt(Place("game/Scene.kt", line)))
        for (line in listOf(6, 15)) assertFalse(edited.isAt(Place("game/Scene.kt", line)))
        assertFalse(edited.isAt(Place("game/Other.kt", 10)))
    }

    @Test
    fun `what the mistakes of the corpus change is known`() {
        val none = (Corpus.mistaken + Corpus.heldOut).filter { Corpus.edits(it).isEmpty() }
        assertEquals(emptyList<Submission>(), none)
        assertEquals(listOf(true), Corpus.edits(Corpus.byName("specular-clamp-missing")).map { it.isShader }.distinct())
    }
}
