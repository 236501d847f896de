package cga.grading.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.random.Random

class GlslTokensTest {
    private fun kinds(source: String) = GlslTokens.of(source).filter { it.kind != TokenKind.SPACE }.map { "${it.kind} ${it.text}" }

    @Test
    fun `words, numbers, signs, comments and directives are told apart`() {
        assertEquals(
            listOf(
                "DIRECTIVE #version 330 core", "COMMENT /* # no */", "DIRECTIVE #define A(x) \\\n x ", "COMMENT // 1f", "WORD a1",
                "SIGN .", "WORD x", "SIGN =",
                "NUMBER 1.5e-3f", "SIGN -", "NUMBER .5", "SIGN +", "NUMBER 0xE", "SIGN +", "NUMBER 1", "SIGN ;", "SIGN #",
            ),
            kinds("#version 330 core\n/* # no */ #define A(x) \\\n x // 1f\na1.x=1.5e-3f-.5+0xE+1; #"),
        )
    }

    @Test
    fun `whatever it is given comes out again`() {
        val random = Random(27)
        val pieces =
            listOf("/*", "*/", "//", "#", "\n", "\r", "\\", " ", "1f", ".", "e-", "x", "(", ")", "{", "}", ";") +
                listOf("in", "out", "vec3", "(float)", "ü", "\u0000")
        repeat(20_000) {
            val source = (0..random.nextInt(24)).joinToString("") { pieces[random.nextInt(pieces.size)] }
            assertEquals(source, GlslTokens.of(source).text())
            Dialect.of(source)
            Varyings(source, source.reversed()).run { zeroed() + interpolated() + matched() }
        }
    }
}
