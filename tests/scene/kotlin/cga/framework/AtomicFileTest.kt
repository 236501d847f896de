package cga.framework

import cga.testing.Need
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.writeText

class AtomicFileTest {
    @TempDir
    private lateinit var folder: Path
    private val target get() = folder.resolve("target")

    @Test
    fun `a file appears whole, and only when it is whole`() {
        AtomicFile.write(target) { temporary ->
            temporary.writeText("half")
            assertTrue(!target.exists() && temporary.parent == target.parent)
            temporary.writeText("whole")
        }
        assertEquals("whole", target.readText())
        assertLeft(target)
    }

    @Test
    fun `an existing file is replaced`() {
        target.writeText("old")
        AtomicFile.write(target) { it.writeText("new") }
        assertEquals("new", target.readText())
        assertLeft(target)
    }

    @Test
    fun `two that write the same file at a time do not meet`() {
        AtomicFile.write(target) { outer ->
            outer.writeText("outer")
            AtomicFile.write(target) { it.writeText("inner") }
            assertEquals("inner", target.readText())
        }
        assertEquals("outer", target.readText())
        assertLeft(target)
    }

    @Test
    fun `a failure leaves neither the target nor a temporary file`() {
        for (failure in listOf(IOException("no space"), InputError("bad"), IllegalStateException("a bug"), OutOfMemoryError("big"))) {
            val thrown = assertThrows<Throwable> { failing(failure) }
            if (failure is IOException) {
                assertTrue(
                    thrown is InputError && "$target" in thrown.message.orEmpty() && "no space" in thrown.message.orEmpty(),
                    "$thrown",
                )
            } else {
                assertEquals(failure, thrown)
            }
            assertLeft()
        }
    }

    @Test
    fun `a failure keeps the file that was there`() {
        target.writeText("old")
        assertThrows<InputError> { failing(IOException("no space")) }
        assertEquals("old", target.readText())
        assertLeft(target)
    }

    @Test
    fun `a target that cannot be written is named before anything is made`() {
        assertRefused(folder, "it is a folder")
        assertRefused(folder.resolve("missing/file"), "the folder ${folder.resolve("missing")} does not exist")
        target.writeText("a file")
        assertRefused(target.resolve("file"), "$target does not exist")
        assertLeft(target)
    }

    @Test
    fun `a name that no file can have is an error like any other`() {
        val long = folder.resolve("x".repeat(300))
        val message = assertThrows<InputError> { AtomicFile.write(long) { it.writeText("") } }.message.orEmpty()
        assertTrue("$long" in message, message)
        assertLeft()
    }

    @Test
    fun `a device or a pipe is not replaced`() {
        val pipe = folder.resolve("pipe")
        assumeTrue(runCatching { ProcessBuilder("mkfifo", "$pipe").start().waitFor() }.getOrNull() == 0, "needs mkfifo")
        assertRefused(pipe, "not a regular file")
        assertTrue(!Files.isRegularFile(pipe))
        assertLeft(pipe)
    }

    @Test
    fun `a read-only folder is named`() {
        val locked = folder.resolve("locked").createDirectory()
        locked.toFile().setWritable(false)
        if (Files.isWritable(locked)) Need.ROOT.skip("root writes anywhere")
        assertRefused(locked.resolve("file"), "the folder $locked is read-only")
    }

    private fun failing(failure: Throwable) =
        AtomicFile.write(target) {
            it.writeText("half")
            throw failure
        }

    private fun assertRefused(
        path: Path,
        reason: String,
    ) {
        val message = assertThrows<InputError> { AtomicFile.write(path) { throw AssertionError("tried to write $it") } }.message.orEmpty()
        assertTrue("cannot write $path" in message && reason in message, message)
    }

    private fun assertLeft(vararg files: Path) = assertEquals(files.toList(), folder.listDirectoryEntries())
}
