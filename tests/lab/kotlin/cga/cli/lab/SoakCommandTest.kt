package cga.cli.lab

import cga.testing.CgaProcess
import cga.testing.NO_DISPLAY
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.Xvfb
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** `cga soak` as its users start it; what it searches with is tried by the tests of the search. */
@Slow
class SoakCommandTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `it says how many points were shaded, and ends with 0 where nothing is found`() {
        Offscreen.openOrSkip().close()
        val process = CgaProcess.cga("soak", "--evaluations", "5000", "--seed", "3", directory = folder)
        assertEquals(0, process.exitCode, "$process")
        assertTrue(Regex("""\d+ points shaded, 0 of them not finite""").containsMatchIn(process.out), "$process")
    }

    @Test
    fun `no points are bad usage`() {
        val process = CgaProcess.cga("soak", "--evaluations", "0", directory = folder)
        assertEquals(2, process.exitCode, "$process")
        assertTrue("--evaluations" in process.err, "$process")
    }

    @Test
    fun `a short soak of the window tells what was held, and its verdict`() {
        Xvfb.openOrSkip().use { display ->
            val fixed = mapOf("JAVA_TOOL_OPTIONS" to "-Xms192m -Xmx192m -XX:+AlwaysPreTouch")
            val process = CgaProcess.cga("soak", "--window", "0.1", directory = folder, env = display.variables + fixed)
            val looks = LOOK.findAll(process.out).count()
            assertTrue(looks in 9..41, "$process")
            val slopes = listOf("resident memory", "live heap", "OpenGL objects").map { "$it: " }
            assertTrue(slopes.all { it in process.out }, "$process")
            // Six seconds of which nearly all is warm-up may grow; the exit code is then another, and says so.
            val isFlat = "flat: nothing grew" in process.out
            assertEquals(if (isFlat) 0 else 1, process.exitCode, "$process")
            assertEquals(!isFlat, " grew: " in process.out, "$process")
        }
    }

    @Test
    fun `without a display, or with a time that is none, it is one message and exit code 2`() {
        assumeTrue(System.getProperty("os.name").startsWith("Linux"))
        for ((minutes, part) in mapOf("1" to "no display", "0" to "0.1", "forever" to "forever")) {
            val process = CgaProcess.cga("soak", "--window", minutes, directory = folder, env = NO_DISPLAY)
            assertEquals(2, process.exitCode, "$process")
            assertTrue(part in process.err && "Exception" !in process.err, "$process")
        }
    }

    private companion object {
        val LOOK = Regex("""\d+ s +\d+ pictures +\d+ MiB resident +\d+\.\d MiB live heap +\d+ OpenGL objects""")
    }
}
