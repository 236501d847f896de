package cga.grading.submission

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Path
import kotlin.random.Random

class SourceTextTest {
    private fun literals(text: String) = SourceText(text).literals.values.toList()

    @Test
    fun `literals are found wherever they stand, and not in comments`() {
        assertEquals(
            listOf("a", "b\\\"c", "raw \"d\"\n", "e"),
            literals("f(\"a\", \"b\\\"c\", \"\"\"raw \"d\"\n\"\"\") // \"x\"\n/* \"y\" /* */ \"z\" */ \"e\""),
        )
        assertEquals(listOf("after"), literals("val quote = '\"'; val back = '\\''; val s = \"after\""))
        assertEquals(listOf("open", "next"), literals("\"open\n\"next\""))
    }

    @Test
    fun `code keeps its place when the rest is blank`() {
        val text = "/* package a */ package b\nval s = \"package c\" // package d\n"
        val code = SourceText(text).code
        assertEquals(text.length, code.length)
        assertEquals(text.indexOf("package b"), code.indexOf("package"))
        assertEquals(code.indexOf("package"), code.lastIndexOf("package"))
    }

    @Test
    fun `what stands alone on a line of a comment is no package, main or class`() {
        val file = SourceFile(
            Path.of("/x/A.java"),
            "A.java",
            "/*\npackage .tmp.x\n public static void main(\nclass Window\n*/\npackage cga.exercise;\nclass A { }\n",
        )
        assertEquals("cga.exercise", file.packageName)
        assertEquals(null, file.mainClass)
        assertFalse(file.declares("Window"))
        assertTrue(file.declares("A"))
        for (none in listOf(".tmp.x", "a..b", "a.")) assertEquals("", SourceFile(Path.of("/x/A.kt"), "A.kt", "package $none\n").packageName)
    }

    @Test
    fun `any text is read to its end`() {
        val random = Random(27)
        val pieces = listOf("\"", "'", "\\", "/*", "*/", "//", "\n", "\"\"\"", "package a", "fun main(", "class B", " ", "x", "\u0000", "ä")
        repeat(20_000) {
            val text = (0 until random.nextInt(30)).joinToString("") { pieces.random(random) }
            val file = SourceFile(Path.of("/x/A.kt"), "A.kt", text)
            assertEquals(text.length, SourceText(text).code.length, text)
            file.mainClass
            StandIn(text).source()
        }
    }
}
