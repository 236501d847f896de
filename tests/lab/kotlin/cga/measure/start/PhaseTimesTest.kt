package cga.measure.start

import cga.framework.InputError
import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeText

@Slow
class PhaseTimesTest {
    @Test
    fun `spans are read, and added up by name`(
        @TempDir folder: Path,
    ) {
        val file = folder.resolve("phases")
        file.writeText("png 4000 4500\ntexture 2000 2250\ntexture 3000 3500\nmain 1000 5000\n")
        val phases = PhaseTimes.read(file, 1000)
        assertEquals(PhaseTime("png", 3.0, 3.5), phases.first())
        assertEquals(listOf("main" to 4.0, "texture" to 0.75, "png" to 0.5), PhaseTimes.byName(phases).toList())
        file.writeText("png 4000\n")
        assertThrows<InputError> { PhaseTimes.read(file, 0) }
    }

    @Test
    fun `a render tells its phases when asked, and nothing otherwise`(
        @TempDir folder: Path,
    ) {
        Offscreen.openOrSkip().close()
        val file = folder.resolve("phases")
        val args = arrayOf("render", "--size", "64x36", "--out", "${folder.resolve("picture.png")}")
        assertEquals(0, CgaProcess.cga(*args, directory = folder).exitCode)
        assertTrue(!file.exists())
        val ended = CgaProcess.cga(*args, directory = folder, env = mapOf("JAVA_TOOL_OPTIONS" to "-Dcga.phases=$file"))
        assertEquals(0, ended.exitCode, "$ended")
        val phases = PhaseTimes.read(file, 0)
        val expected = listOf("main", "context", "gl-functions", "scene", "model", "texture", "draw", "shaders", "read", "png")
        assertTrue(phases.map { it.name }.containsAll(expected)) { "$phases" }
        val main = phases.single { it.name == "main" }
        assertTrue(phases.all { it.start in main.start..it.end && it.end <= main.end }) { "$phases" }
    }
}
