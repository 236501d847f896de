package cga.grading.capture

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Path
import java.util.jar.JarFile
import kotlin.io.path.readBytes

class WorkerFilesTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `the worker's jar holds its classes and none that a submission may have too`() {
        val jar = folder.resolve("worker.jar")
        WorkerFiles.writeJar(jar)
        val names = JarFile(jar.toFile()).use { file -> file.entries().toList().map { it.name } }
        assertTrue("cga/grading/worker/WorkerMain.class" in names && "cga/grading/capture/Capture.class" in names, "$names")
        val others = names.filterNot { it.matches(Regex("cga/(grading/capture|grading/worker|coach/calls)/[^/]+\\.class")) }
        assertEquals(listOf("META-INF/services/javax.sound.sampled.spi.MixerProvider"), others)
        val again = folder.resolve("again.jar")
        WorkerFiles.writeJar(again)
        assertArrayEquals(jar.readBytes(), again.readBytes())
    }

    @Test
    fun `the libraries are those of the course, and natives of this machine only`() {
        val names = WorkerFiles.libraries().map { it.fileName.toString() }
        for (library in listOf("kotlin-stdlib-", "lwjgl-3", "lwjgl-glfw-3", "lwjgl-opengl-3", "lwjgl-stb-3", "lwjgl-assimp-3", "joml-")) {
            assertTrue(names.any { it.startsWith(library) }, "$library in $names")
        }
        assertTrue(names.none { it.startsWith("clikt") || it.startsWith("kotlinx") || it.startsWith("junit") }, "$names")
        assertEquals(1, names.mapNotNull { Regex("natives-([\\w-]+)\\.jar").find(it)?.groupValues?.get(1) }.distinct().size, "$names")
    }

    @Test
    fun `the class path is what an archive is made of, the submission's classes are the worker's to load`() {
        val run = WorkerRun(listOf(Path.of("/s/classes"), Path.of("/s/more")), Path.of("/w.jar"), "MainKt", Path.of("/out/capture"))
        val command = WorkerFiles.command(run)
        assertEquals(listOf("cga.grading.worker.WorkerMain", "MainKt", "/out/capture", "/s/classes", "/s/more"), command.takeLast(5))
        val path = command[command.indexOf("-cp") + 1].split(File.pathSeparator)
        assertEquals("/w.jar", path.first())
        assertTrue(path.none { it.startsWith("/s/") }, "$path")
    }
}
