package cga.grading.compile

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.zip.ZipFile

class PlainJarTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `JOML loses its list of Kotlin functions and nothing else`() {
        val joml = System.getProperty("java.class.path").split(':').map(Path::of).single { "${it.fileName}".startsWith("joml-") }
        assertTrue(PlainJar.isNeeded(joml))
        val plain = folder.resolve("plain.jar")
        PlainJar.write(joml, plain)
        assertFalse(PlainJar.isNeeded(plain))
        assertEquals(contents(joml) - "META-INF/joml.kotlin_module", contents(plain))
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
