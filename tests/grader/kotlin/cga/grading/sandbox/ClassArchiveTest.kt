package cga.grading.sandbox

import cga.grading.capture.WorkerFiles
import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.io.File
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import kotlin.io.path.createTempDirectory
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.outputStream
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.setLastModifiedTime

@Slow
class ClassArchiveTest {
    private val folder = createTempDirectory("class-archive")
    private val jar = folder.resolve("worker.jar").also(WorkerFiles::writeJar)
    private val libraries = WorkerFiles.own(jar)

    @AfterEach
    fun delete() {
        folder.toFile().deleteRecursively()
    }

    private fun archive() = ClassArchive.of(folder, "worker", libraries, WorkerFiles.FLAGS, listOf("org/joml/"), listOf { listOf(MAIN) })

    /** Where the JVM of a worker that cannot start anything takes its classes from. */
    private fun sources(archive: ClassArchive, classPath: List<Path> = libraries): List<String> {
        val log = folder.resolve("loaded")
        val java = "${Path.of(System.getProperty("java.home"), "bin", "java")}"
        val path = classPath.joinToString(File.pathSeparator)
        val command = listOf(java) + WorkerFiles.FLAGS + archive.options + listOf("-Xlog:class+load:file=$log", "-cp", path, MAIN)
        ProcessBuilder(command).redirectErrorStream(true).redirectOutput(folder.resolve("said").toFile()).start().waitFor()
        return log.readLines().filter { " $MAIN source:" in it }
    }

    @Test
    fun `a job takes its classes from the archive and says nothing of it`() {
        val archive = archive()
        assertTrue(sources(archive).single().endsWith("shared objects file")) { "${sources(archive)}" }
        val said = folder.resolve("said").readText().trim().lines()
        assertEquals(listOf("usage: WorkerMain <class with main> <capture file> <classes>…"), said)
    }

    @Test
    fun `it is made once, and anew for another jar, and a job with the old one still starts`() {
        val first = archive()
        assertEquals(first.file, archive().file)
        jar.setLastModifiedTime(FileTime.fromMillis(jar.getLastModifiedTime().toMillis() - 10_000))
        val second = archive()
        assertNotEquals(first.file, second.file)
        assertEquals(listOf(second.file?.name), folder.listDirectoryEntries("*.jsa").map { it.name })
        assertTrue("worker.jar" in sources(first).single()) { "${sources(first)}" }
    }

    @Test
    fun `a class whose name has blanks, as those of tests, is left out`() {
        val tests = folder.resolve("tests.jar")
        JarOutputStream(tests.outputStream()).use { it.putNextEntry(JarEntry("org/joml/a name with blanks.class")) }
        val path = libraries + listOf(tests)
        val archive = ClassArchive.of(folder, "tests", path, WorkerFiles.FLAGS, listOf("org/joml/"), listOf { listOf(MAIN) })
        assertTrue(sources(archive, path).single().endsWith("shared objects file")) { "${sources(archive, path)}" }
    }

    @Test
    fun `there is none where classes are in folders`() {
        assertTrue(ClassArchive.of(folder, "folders", listOf(folder), emptyList(), emptyList(), listOf { listOf(MAIN) }).options.isEmpty())
    }

    private companion object {
        const val MAIN = "cga.grading.worker.WorkerMain"
    }
}
