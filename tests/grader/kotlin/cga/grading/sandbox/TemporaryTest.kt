package cga.grading.sandbox

import cga.testing.CgaProcess
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeText

class TemporaryTest {
    @TempDir
    private lateinit var folder: Path

    /** A process that has made a temporary folder, and waits. */
    private fun start(): Process {
        val command = CgaProcess.command("cga.grading.sandbox.TemporaryTestKt", emptyList(), projectRoot.toPath())
        val process = ProcessBuilder(listOf(command.first(), "-Djava.io.tmpdir=$folder") + command.drop(1)).inheritErrors().start()
        assertTrue(Path.of(process.inputReader().readLine()).exists())
        return process
    }

    private fun ProcessBuilder.inheritErrors() = redirectError(ProcessBuilder.Redirect.INHERIT)

    private fun left() = folder.listDirectoryEntries("cga-grader-*")

    @Test
    fun `what a killed process leaves goes when the next one starts, and what a living one has stays`() {
        start().destroyForcibly().waitFor()
        assertEquals(1, left().size)
        val killed = left().single()
        // Not ours to remove: nobody has locked it yet.
        val new = folder.resolve("cga-grader-new").createDirectory()
        val living = start()
        try {
            assertTrue(!killed.exists() && new.exists())
            val its = left().single { it.name != new.name }
            start().also { it.outputStream.close() }.waitFor(10, SECONDS)
            assertEquals(setOf(its, new), left().toSet())
        } finally {
            living.destroyForcibly().waitFor()
        }
    }

    @Test
    fun `who ends by himself leaves nothing`() {
        val process = start()
        process.outputStream.close()
        assertTrue(process.waitFor(10, SECONDS))
        assertEquals(emptyList<Path>(), left())
    }
}

/** Makes a temporary folder, prints its path, and waits for the end of its input. */
fun main() {
    println(Temporary.folder("test").apply { resolve("file").writeText("here") })
    System.`in`.read()
}
