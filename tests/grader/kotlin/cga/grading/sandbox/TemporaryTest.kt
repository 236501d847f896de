package cga.grading.sandbox

import cga.testing.CgaProcess
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.concurrent.thread
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeText

class TemporaryTest {
    @TempDir
    private lateinit var folder: Path

    /** A process that has made a temporary folder, and waits. */
    private fun start(vararg arguments: String): Process {
        val command = CgaProcess.command("cga.grading.sandbox.TemporaryTestKt", arguments.toList(), projectRoot.toPath())
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
            start().also { it.outputStream.close() }.waitFor(PATIENCE, SECONDS)
            assertEquals(setOf(its, new), left().toSet())
        } finally {
            living.destroyForcibly().waitFor()
        }
    }

    @Test
    fun `who ends by himself leaves nothing`() {
        val process = start()
        process.outputStream.close()
        assertTrue(process.waitFor(PATIENCE, SECONDS))
        assertEquals(emptyList<Path>(), left())
    }

    @Test
    fun `a job ends with whoever started it, and its folder goes with the next start`() {
        Hostile.confined()
        for (signal in listOf("KILL", "INT")) {
            val process = start("job")
            assertTrue(isJobAlive())
            ProcessBuilder("kill", "-$signal", "${process.pid()}").start().waitFor()
            assertTrue(process.waitFor(PATIENCE, SECONDS))
            // The kernel's word that the parent died takes a moment.
            val end = System.nanoTime() + SECONDS.toNanos(PATIENCE)
            while (isJobAlive() && System.nanoTime() < end) Thread.sleep(10)
            assertFalse(isJobAlive(), signal)
            start().also { it.outputStream.close() }.waitFor(PATIENCE, SECONDS)
            assertEquals(emptyList<Path>(), left(), signal)
        }
    }

    /** Whether a process is told to write into a folder made here. */
    private fun isJobAlive() = Hostile.isAlive("$folder/cga-grader-")

    private companion object {
        /** Against a hang; a machine with too much to do takes long to start a process. */
        const val PATIENCE = 120L
    }
}

/** Makes a temporary folder, has a job fill it where that is asked for, prints its path, and waits for the end of its input. */
fun main(arguments: Array<String>) {
    val scratch = Temporary.folder("test").apply { resolve("file").writeText("here") }
    if (arguments.isNotEmpty()) {
        val command = "echo here >$scratch/job; while :; do mkdir -p $scratch/a/b; touch $scratch/a/b/c; sleep 271; done"
        thread(isDaemon = true) { Sandbox.confined().run(Job(listOf("sh", "-c", command), scratch, limits = Limits(wallSeconds = 271.0))) }
        while (!scratch.resolve("job").exists()) Thread.sleep(10)
    }
    println(scratch)
    System.`in`.read()
}
