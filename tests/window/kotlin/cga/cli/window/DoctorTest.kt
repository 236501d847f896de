package cga.cli.window

import cga.testing.CgaProcess
import cga.testing.NO_DISPLAY
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import cga.testing.withoutOpenGL
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** `cga doctor`: a row for each kind of context. */
@Slow
class DoctorTest {
    @Test
    fun `it lists each kind with version and renderer or the reason`(
        @TempDir folder: Path,
    ) {
        Offscreen.openOrSkip().close()
        assumeTrue(System.getProperty("os.name").startsWith("Linux"))
        val process = CgaProcess.cga("doctor", directory = folder, env = NO_DISPLAY)
        assertEquals(0, process.exitCode, "$process")
        assertTrue("Java ${System.getProperty("java.version")}" in process.out && "LWJGL 3" in process.out, "$process")
        val rows = rows(process.out)
        assertEquals(setOf("osmesa", "egl", "window"), rows.keys)
        for ((kind, row) in rows) {
            val cure = if (kind == "window") "xvfb-run" else "apt-get install"
            val wanted = if (" yes " in row) listOf("OpenGL", "GLSL") else listOf(" no ", cure)
            for (part in wanted) assertTrue(part in row, "$kind: $row")
        }
        assertTrue(" no " in rows.getValue("window") && "no display" in rows.getValue("window"), "$process")
    }

    @Test
    fun `where nothing works it says so and fails`(
        @TempDir folder: Path,
    ) {
        assumeTrue(System.getProperty("os.name").startsWith("Linux"))
        val process = CgaProcess.cga("doctor", directory = folder, env = withoutOpenGL(folder))
        assertEquals(2, process.exitCode, "$process")
        val rows = rows(process.out)
        for ((kind, cure) in mapOf("osmesa" to "libosmesa6", "egl" to "libgl1-mesa-dri", "window" to "xvfb-run")) {
            assertTrue(" no " in rows.getValue(kind) && cure in rows.getValue(kind), "$kind: $process")
        }
    }

    @Test
    fun `of a sound scene it says that it is lit, and of a black one why, by the exit code too`(
        @TempDir folder: Path,
    ) {
        Offscreen.openOrSkip().close()
        val sound = CgaProcess.cga("doctor", "--scene", directory = folder, env = NO_DISPLAY)
        assertEquals(0, sound.exitCode, "$sound")
        assertEquals("The picture of step 4.7 is lit.\nNone of the usual mistakes was found.\n", sound.out, "$sound")

        for (name in listOf("shaders", "assets")) projectRoot.resolve(name).copyRecursively(folder.resolve(name).toFile())
        val shader = folder.resolve("shaders/scene.frag")
        val good = shader.readText()
        shader.writeText(good.replace("fragColor = vec4(", "fragColor = sqrt(-1.0 - emissive.r) * vec4("))
        val black = CgaProcess.cga("doctor", "--scene", "--step", "4.3", directory = folder, home = folder, env = NO_DISPLAY)
        assertEquals(1, black.exitCode, "$black")
        assertTrue("The picture of step 4.3 is black." in black.out && "\n1. " in black.out && "NaN" in black.out, "$black")

        shader.writeText("no GLSL")
        val broken = CgaProcess.cga("doctor", "--scene", directory = folder, home = folder, env = NO_DISPLAY)
        assertEquals(2, broken.exitCode, "$broken")
        assertTrue("scene.frag" in broken.err && "Exception" !in broken.err, "$broken")
        val early = CgaProcess.cga("doctor", "--scene", "--t", "-1", directory = folder, env = NO_DISPLAY)
        assertEquals(2, early.exitCode, "$early")
        assertTrue("--t -1" in early.err, "$early")
    }

    /** The table's rows by their first cell, wrapped text put together again. */
    private fun rows(table: String): Map<String, String> {
        val rows = mutableMapOf<String, String>()
        var kind = ""
        for (line in table.lines().filter { it.startsWith("│") }) {
            val cells = line.split("│").map { it.trim() }
            if (cells[1].isNotEmpty()) kind = cells[1]
            rows.merge(kind, " ${cells[2]} ${cells[3]}", String::plus)
        }
        return rows - "context"
    }
}
