package cga.grading.course

import cga.testing.CgaProcess
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.appendText
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText

/** A course that is killed in the middle, as an operating system kills: nothing is asked, nothing is told. */
@Slow
class KilledCourseTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `it goes on where it was and repeats nothing that was done`() {
        val submissions = FakeGrader.submissions(folder.resolve("in"), *Array(12) { "s$it" to if (it % 3 == 0) "phong" else "right" })
        val killed = start()
        val log = folder.resolve("graded.log")
        val done = {
            folder.resolve("out").let { out ->
                if (out.exists()) submissions.count { out.resolve("${it.folder}/outcome.json").exists() } else 0
            }
        }
        val end = System.nanoTime() + SECONDS.toNanos(60)
        // In the middle: some are done, some are being graded.
        while (done() < 4) {
            check(System.nanoTime() < end && killed.isAlive) { "waited in vain; it says ${folder.resolve("stdout").readText()}" }
            Thread.sleep(5)
        }
        killed.destroyForcibly().waitFor()
        val kept = submissions.filter { folder.resolve("out/${it.folder}/outcome.json").exists() }.map { it.name }
        assertTrue(kept.size in 4..11) { "$kept" }
        val interrupted = Journal(folder.resolve("out/${Journal.NAME}")).interrupted()
        assertTrue(interrupted.none { it in kept } || interrupted.size <= 2) { "$interrupted" }
        // Half a line, as a kill can leave it.
        folder.resolve("out/${Journal.NAME}").appendText("{\"time\":\"2026-")

        val again = start()
        assertTrue(again.waitFor(60, SECONDS))
        assertEquals(0, again.exitValue()) { folder.resolve("stdout").readText() }
        val times = log.readLines().groupingBy { it }.eachCount()
        for (name in kept) assertEquals(1, times[name], "$name was done and graded again")
        assertEquals(submissions.map { it.name }.toSet(), times.keys)
        // Two workers: at most two were under way.
        assertTrue(times.values.sum() <= submissions.size + 2)
        val results = submissions.map { OutcomeFile.read(folder.resolve("out/${it.folder}")) }
        assertEquals(submissions.map { it.name }, results.map { it.name })
        assertEquals(emptySet<String>(), Journal(folder.resolve("out/${Journal.NAME}")).interrupted())
        val strays = folder.resolve("out").listDirectoryEntries().filter {
            it.isDirectory() && it.name !in submissions.map { s ->
                s.folder
            }
        }
        assertEquals(emptyList<Path>(), strays)
    }

    private fun start(): Process =
        ProcessBuilder(CgaProcess.command("cga.grading.course.KilledCourseKt", listOf("$folder"), projectRoot.toPath()))
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("stdout").toFile())
            .start()
}
