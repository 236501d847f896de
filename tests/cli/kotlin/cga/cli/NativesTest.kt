package cga.cli

import cga.testing.CgaProcess
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createFile
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeText

/** The folder of LWJGL's unpacked libraries, as the launcher names it. */
class NativesTest {
    @TempDir
    private lateinit var folder: Path
    private val natives get() = folder.resolve("natives")

    @BeforeEach
    fun `there is a context`() = Offscreen.openOrSkip().close()

    @Test
    fun `each library is unpacked once, and loaded from there`() {
        render()
        val library = natives.walk().single { it.name == System.mapLibraryName("lwjgl") }
        val unpacked = library.getLastModifiedTime()
        render()
        assertEquals(unpacked, library.getLastModifiedTime())
        // No library any more: what is in the folder is what is loaded.
        library.writeText("no library")
        val broken = start()
        assertTrue(broken.exitCode != 0 && "$library" in broken.err, "$broken")
    }

    @Test
    fun `where nothing can be unpacked a picture is rendered all the same`() {
        natives.createFile()
        render()
        assertEquals("", natives.readText())
    }

    private fun render() {
        val process = start()
        assertEquals(0, process.exitCode, "$process")
        assertTrue(folder.resolve("a.png").exists())
    }

    private fun start() =
        CgaProcess.cga(
            "render",
            "--size",
            "8x8",
            "--out",
            "a.png",
            directory = folder,
            env = mapOf("JAVA_TOOL_OPTIONS" to "-Dcga.natives=$natives"),
        )
}
