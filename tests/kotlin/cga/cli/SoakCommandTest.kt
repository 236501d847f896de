package cga.cli

import cga.testing.CgaProcess
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** `cga soak` as its users start it; what it searches with is tried by the tests of the search. */
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
}
