package cga.grading.compile

import cga.grading.prepared.PreparedSource
import cga.grading.sandbox.End
import cga.grading.sandbox.Limit
import cga.grading.sandbox.Outcome
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What is made of what compilers print. */
class CompilerOutputTest {
    private val scene = PreparedSource("src/game/Scene.kt", "0000/Scene.kt")
    private val helper = PreparedSource("src/Helper.java", "0001/Helper.java")

    private fun errors(text: String, end: End = End.Exited(1)) =
        CompilerOutput(listOf(scene, helper)).errors(Outcome(end, "", text, 1.0, 1.0, 1))

    @Test
    fun `errors of both compilers name the file as the student does, with the line`() {
        val text = "warning: something\n/a:b/w/sources/0000/Scene.kt:12:5: error: unresolved: error: x\n  val y\n     ^\n" +
            "/a:b/w/sources/0001/Helper.java:7: error: ';' expected\n1 error\n"
        val expected = listOf(CompileError(scene, 12, "unresolved: error: x"), CompileError(helper, 7, "';' expected"))
        assertEquals(expected, errors(text))
        assertEquals(emptyList<CompileError>(), errors(text, End.Exited(0)))
    }

    @Test
    fun `a file that nobody staged is none`() {
        for (path in listOf("/w/sources/0007/Scene.kt:1:1", "Scene.kt:1:1", "0000/Scene.kt/x:1:1", "0000/Scene.kt:1:2:3", "")) {
            assertTrue(errors("$path: error: wrong").single().source == null, path)
        }
    }

    @Test
    fun `a compiler that fails names a file, or it does not`() {
        val named = errors("exception: org.x.Failure: while compiling /w/sources/0000/Scene.kt (3,4)\n\tat org.x.Y(Z.kt:1)\n").single()
        assertEquals(CompileError(scene, 0, "org.x.Failure: while compiling src/game/Scene.kt (3,4)"), named)
        assertEquals(CompileError(null, 0, "java.lang.StackOverflowError"), errors("exception: java.lang.StackOverflowError\n").single())
        assertEquals(null, errors("", End.Exceeded(Limit.MEMORY)).single().source)
        assertTrue(listOf("exception: x", "").all { errors(it).single().isCompilers })
    }
}
