package cga.grading.report

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class CleanTextTest {
    @Test
    fun `what a reader or a terminal would obey is shown instead`() {
        assertEquals("a�b�c\n\td", clean("a\u0000b\u202Ec\r\n\td"))
        assertEquals("e: error", clean("\u001B[31me:\u001B[0m error"))
        assertEquals("�[2J", clean("\u001B[2J"))
        assertEquals("��\uFFFD", clean("\uD800\uFFFE\uFFFF"))
        assertEquals("ä😀", clean("ä😀"))
    }

    @Test
    fun `a line is one line, and cut before half a character`() {
        assertEquals("a b", cleanLine(" a\n\t b "))
        assertEquals("ab…", cleanLine("ab😀cd", limit = 4))
    }
}
