package cga.measure

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.writeText

class MarkedDocumentTest {
    @TempDir
    private lateinit var folder: Path
    private val file by lazy { folder.resolve("doc.md") }

    @Test
    fun `what stands between the marks is replaced, and nothing else`() {
        file.writeText("before\n<!-- table:a -->\nold\nold\n<!-- end -->\nbetween\n<!-- plot:b -->\n<!-- end -->\nafter\n")
        MarkedDocument.read(file).with("table:a", "| new |\n").with("plot:b", "picture").write()
        val expected = "before\n<!-- table:a -->\n\n| new |\n\n<!-- end -->\nbetween\n<!-- plot:b -->\n\npicture\n\n<!-- end -->\nafter\n"
        assertEquals(expected, file.readText())
        MarkedDocument.read(file).with("table:a", "| new |").write()
        assertEquals(expected, file.readText(), "filled in twice")
        assertEquals(listOf(file), folder.listDirectoryEntries())
    }

    @Test
    fun `a marker that is missing, twice there or without its end is refused by name`() {
        assertRefused("text\n", "<!-- table:a --> 0 times")
        assertRefused("<!-- table:a -->\n<!-- end -->\n<!-- table:a -->\n<!-- end -->\n", "<!-- table:a --> 2 times")
        assertRefused("x\n<!-- table:a -->\n", "doc.md:2: <!-- table:a --> has no end")
        // The end below is that of the other.
        assertRefused("<!-- table:a -->\n<!-- table:b -->\n<!-- end -->\n", "doc.md:1: <!-- table:a --> has no end")
    }

    @Test
    fun `a document that is not there is refused`() {
        assertTrue("does not exist" in assertThrows(InputError::class.java) { MarkedDocument.read(file) }.message.orEmpty())
    }

    private fun assertRefused(
        text: String,
        expected: String,
    ) {
        file.writeText(text)
        for (use in listOf<(MarkedDocument) -> Unit>({ it.require("table:a") }, { it.with("table:a", "x") })) {
            val message = assertThrows(InputError::class.java) { use(MarkedDocument.read(file)) }.message.orEmpty()
            assertTrue(expected in message) { message }
        }
        assertEquals(text, file.readText())
    }
}
