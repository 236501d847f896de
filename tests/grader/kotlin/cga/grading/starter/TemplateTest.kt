package cga.grading.starter

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

class TemplateTest {
    @Test
    fun `of a solution a TODO for each task remains, and the code that stands in for it`() {
        val solution =
            """
            fun f(): Int {
                // solution 4.2.1: think
                // solution 4.3: think again
                // instead: return 0
                // it was 42 all the time
                return 42
                // end of solution
            }
            """.trimIndent()
        val starter =
            """
            fun f(): Int {
                // TODO 4.2.1: think
                // TODO 4.3: think again
                return 0
            }
            """.trimIndent()
        assertEquals(starter, Template("f.kt", solution).starter)
    }

    @Test
    fun `each task is told in the language that was asked for`() {
        val solution = "// solution 4.4: send the colour\n// Lösung 4.4: Senden Sie die Farbe\nx\n// end of solution\n"
        assertEquals("// TODO 4.4: send the colour\n", Template("f.kt", solution).starter)
        assertEquals("// TODO 4.4: Senden Sie die Farbe\n", Template("f.kt", solution, StarterLanguage.GERMAN).starter)
    }

    @Test
    fun `a solution without a task leaves nothing`() {
        assertEquals("a\nb\n", Template("f.kt", "a\n// solution\nhelp\n// end of solution\nb\n").starter)
    }

    @Test
    fun `a file without solutions stays as it is`() {
        val text = "// a solution in words\nval x = 1 // solution\n\n"
        assertEquals(text, Template("f.kt", text).starter)
    }

    @Test
    fun `what was cut out goes back to where it was`() {
        val first = "// solution\na\n// end of solution\nb\n"
        val solution = first + "  // solution 4.4: c\n  // instead: d\n  // end of solution\n// solution\n// end of solution"
        val template = Template("f.kt", solution)
        assertEquals("b\n  // TODO 4.4: c\n  d", template.starter)
        assertEquals(solution, Template.solution(template.starter, template.regions))
    }

    @Test
    fun `a starter that was changed is not taken for one`() {
        val template = Template("f.kt", "// solution 4.4: c\nx\n// end of solution")
        assertThrows<IllegalArgumentException> { Template.solution("// TODO 4.4: d", template.regions) }
    }

    @Test
    fun `markers out of place are named`() {
        assertWrong("f.kt:2: ", "has no // end of solution", "a\n// solution 4.2: x\nb")
        assertWrong("f.kt:3: ", "within a solution", "// solution\na\n// solution\n// end of solution\n// end of solution")
        assertWrong("f.kt:3: ", "within a solution", "// solution\na\n// instead: b\n// end of solution")
        assertWrong("f.kt:1: ", "no solution", "// end of solution")
        assertWrong("f.kt:1: ", "no solution", "// instead: x")
    }

    private fun assertWrong(
        place: String,
        reason: String,
        text: String,
    ) {
        val message = assertThrows<InputError> { Template("f.kt", text) }.message.orEmpty()
        assertTrue(message.startsWith(place) && reason in message) { message }
    }
}
