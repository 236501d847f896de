package cga.grading.course

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.writeText

class InputChecksumTest {
    @TempDir
    lateinit var folder: Path

    private fun sum() = InputChecksum.of(folder.resolve("a"), "s")

    private fun write(name: String, text: String) = folder.resolve("a").resolve(name).also { it.parent.createDirectories() }.writeText(text)

    @Test
    fun `it changes with every name, content and setting and with nothing else`() {
        write("x", "1")
        write("b/y", "2")
        val first = sum()
        assertEquals(first, sum())
        folder.resolve("a/x").toFile().setLastModified(0)
        assertEquals(first, sum())
        assertNotEquals(first, InputChecksum.of(folder.resolve("a"), "t"))
        write("x", "2")
        val second = sum()
        assertNotEquals(first, second)
        Files.move(folder.resolve("a/x"), folder.resolve("a/z"))
        assertNotEquals(second, sum())
    }

    @Test
    fun `the border between two files counts`() {
        write("x", "12")
        write("y", "3")
        val first = sum()
        write("x", "1")
        write("y", "23")
        assertNotEquals(first, sum())
    }

    @Test
    fun `links are not followed and pipes are not read`() {
        write("x", "1")
        val endless = folder.resolve("a/loop").createSymbolicLinkPointingTo(folder.resolve("a"))
        folder.resolve("a/zero").createSymbolicLinkPointingTo(Path.of("/dev/zero"))
        ProcessBuilder("mkfifo", "${folder.resolve("a/pipe")}").start().waitFor()
        val first = sum()
        Files.delete(endless)
        assertNotEquals(first, sum())
    }

    @Test
    fun `of what is larger than any project only the size counts`() {
        write("x", "1")
        RandomAccessFile(folder.resolve("a/sparse").toFile(), "rw").use { it.setLength(30L shl 30) }
        val first = sum()
        RandomAccessFile(folder.resolve("a/sparse").toFile(), "rw").use { it.setLength(31L shl 30) }
        assertNotEquals(first, sum())
        write("x", "2")
        assertNotEquals(first, sum())
    }

    @Test
    fun `an archive counts by its bytes, and nothing is called missing`() {
        val file = folder.resolve("a.zip").apply { writeText("PK") }
        val first = InputChecksum.of(file, "s")
        file.writeText("PL")
        assertNotEquals(first, InputChecksum.of(file, "s"))
        assertEquals("missing", InputChecksum.of(folder.resolve("gone"), "s"))
    }
}
