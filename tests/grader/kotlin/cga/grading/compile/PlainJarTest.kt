package cga.grading.compile

import cga.grading.capture.WorkerFiles
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.net.URLClassLoader
import java.nio.file.Path
import java.util.zip.ZipFile
import kotlin.io.path.writeText

class PlainJarTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `JOML loses its list of Kotlin functions, and nothing but its classes of Kotlin changes`() {
        val joml = System.getProperty("java.class.path").split(':').map(Path::of).single { "${it.fileName}".startsWith("joml-") }
        assertTrue(PlainJar.isNeeded(joml))
        val plain = folder.resolve("plain.jar")
        PlainJar.write(joml, plain)
        assertFalse(PlainJar.isNeeded(plain))
        val (before, after) = contents(joml) - "META-INF/joml.kotlin_module" to contents(plain)
        assertEquals(before.keys, after.keys)
        assertEquals(emptyList<String>(), before.filter { (name, sum) -> after[name] != sum && !name.endsWith("Kt.class") }.keys.toList())
    }

    @Test
    fun `classes of a newer Kotlin are those of an old Java, and can be loaded all the same`() {
        val worker = folder.resolve("worker.jar").also(WorkerFiles::writeJar)
        assertTrue(PlainJar.isNeeded(worker))
        val plain = folder.resolve("plain.jar")
        PlainJar.write(worker, plain)
        assertFalse(PlainJar.isNeeded(plain))
        assertEquals(contents(worker).keys, contents(plain).keys)
        val library = Regex(".*/(kotlin-stdlib|lwjgl)-[^/]*\\.jar")
        val libraries = System.getProperty("java.class.path").split(':').filter(library::matches)
        val urls = (listOf(plain) + libraries.map(Path::of)).map { it.toUri().toURL() }
        URLClassLoader(urls.toTypedArray(), ClassLoader.getPlatformClassLoader()).use { loader ->
            val stage = loader.loadClass("cga.grading.worker.Stage")
            assertEquals(0, stage.getField("END").getInt(null))
            assertEquals(emptyList<Annotation>(), stage.annotations.toList())
        }
    }

    @Test
    fun `other contents have another name`() {
        val names = listOf("a", "b", "a").map { text -> PlainJar.name(folder.resolve("x.jar").apply { writeText(text) }) }
        assertEquals(names[0], names[2])
        assertFalse(names[0] == names[1])
    }

    /** Checksums by name. */
    private fun contents(
        jar: Path,
    ) = ZipFile(jar.toFile()).use { zip ->
        zip.entries().asSequence().filterNot { it.isDirectory }.associate {
            it.name to
                it.crc
        }
    }
}
