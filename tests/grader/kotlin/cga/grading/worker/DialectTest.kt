package cga.grading.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class DialectTest {
    private val plain = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n"

    @Test
    fun `what is as it should be is only tried with extensions`() {
        val only = Dialect.of(plain).single()
        assertTrue(only.startsWith("#version 330 core\n#extension "), only)
        assertTrue(only.endsWith(plain.substringAfter('\n')), only)
    }

    @Test
    fun `a byte order mark is left out`() = assertEquals(plain, Dialect.of("\uFEFF$plain").first())

    @Test
    fun `the version comes first, and lines keep their order`() {
        assertEquals("#version 330 core\n// mine\nvoid main() {}", Dialect.of("// mine\n  #version 330 core\nvoid main() {}").first())
        assertEquals("#version 330 core\nvoid main() {}", Dialect.of("void main() {}").first())
    }
}
