package cga.measure.twin

import cga.exercise.game.DriveScript
import cga.exercise.game.Step
import cga.framework.InputError
import cga.framework.context.ContextKind
import cga.framework.image.ImageData
import cga.testing.FLOAT_ROUNDING
import cga.testing.Need
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.writeLines
import kotlin.math.sqrt

/** The C++ twin draws through the same library in a process of its own. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class TwinRenderTest {
    private lateinit var twin: Twin

    @BeforeAll
    fun compile(
        @TempDir folder: Path,
    ) {
        twin =
            try {
                Twin.compile(folder)
            } catch (e: NoCompiler) {
                Need.GLM.skip(e.message.orEmpty())
            }
    }

    private val turned = DriveScript.parse("WA 0.7, W 0.5")

    @Test
    fun `the twin's picture is ours to the byte, at every step and through OSMesa and EGL`(
        @TempDir folder: Path,
    ) {
        val samples = listOf(Step.SPOT_LIGHT, Step.FINAL).map { TwinShot(it, 320, 180, samples = 4, drive = turned) }
        val shots =
            mapOf(
                ContextKind.OSMESA to Step.entries.map { TwinShot(it, 320, 180, mouse = 300.0, drive = turned) } + samples,
                ContextKind.EGL to samples + TwinShot(width = 33, height = 77),
            )
        for ((kind, those) in shots) {
            for (shot in those) {
                val recorded = record(kind, shot)
                val recording = Recording.write(recorded, folder.resolve("$kind-$shot".filter(Char::isLetterOrDigit)).createDirectory())
                assertSame(recorded.picture, twin.picture(recording, kind), "$kind $shot")
            }
        }
    }

    @Test
    fun `a changed uniform is seen`(
        @TempDir folder: Path,
    ) {
        val recorded = record(ContextKind.OSMESA, TwinShot(width = 320, height = 180))
        val recording = Recording.write(recorded, folder)
        val line = recording.readLines().single { it.startsWith("uniform m4 projection ") }
        val first = line.split(' ')[3]
        val other = java.lang.Double.toHexString(first.toDouble() * 1.001)
        recording.writeLines(recording.readLines().map { if (it == line) it.replaceFirst(first, other) else it })
        assertNotEquals(recorded.picture.rgba.asList(), twin.picture(recording, ContextKind.OSMESA).rgba.asList())
    }

    /**
     * GLM's floats: each number is a sum of products through at most four matrices, 20 roundings, of coordinates no larger here than 10
     * times the uniform's largest number. The inverse of a turn with one scale makes no error larger.
     */
    @Test
    fun `GLM's own matrices are ours but for the rounding, and so is their picture`(
        @TempDir folder: Path,
    ) {
        val recorded = record(ContextKind.OSMESA, TwinShot(width = 320, height = 180, mouse = 300.0, drive = turned))
        val recording = Recording.write(recorded, folder)
        val differences = twin.differences(recording, ContextKind.OSMESA)
        assertTrue("modelView" in differences.keys) { "GLM rounds as we do everywhere: $differences" }
        for ((name, difference) in differences) assertTrue(difference <= 20 * 10 * FLOAT_ROUNDING) { "$name is off by $difference" }
        val picture = twin.picture(recording, ContextKind.OSMESA, own = true)
        assertTrue(rootMeanSquare(recorded.picture, picture) < 1.0) { "${rootMeanSquare(recorded.picture, picture)}" }
    }

    @Test
    fun `frames are timed, and a picture is written as PNG`(
        @TempDir folder: Path,
    ) {
        val recorded = record(ContextKind.OSMESA, TwinShot(width = 101, height = 97))
        val recording = Recording.write(recorded, folder)
        for (own in listOf(false, true)) {
            val times = twin.frameTimes(recording, ContextKind.OSMESA, 3, own)
            assertEquals(3, times.size)
            assertTrue(times.all { it.clock > 0 && it.thread > 0 }) { "$times" }
        }
        val png = folder.resolve("twin.png")
        assertEquals(0, ProcessBuilder(twin.command(recording, ContextKind.OSMESA, png)).start().waitFor())
        assertSame(recorded.picture, ImageData.read("$png"), "PNG")
    }

    @Test
    fun `what the twin cannot use it refuses in one sentence`(
        @TempDir folder: Path,
    ) {
        val recording = folder.resolve(Recording.FILE)
        val head = listOf("cga-twin 1", "size 8 8", "samples 0")
        val bad =
            mapOf(
                listOf("cga-twin 9", "size 8 8") to "no recording of this version",
                head + "nonsense" to ":4: what is 'nonsense'?",
                head + "uniform f3 ambient 0x0p0" to "is no number",
                head + "model missing.model" to "cannot read missing.model",
            )
        for ((lines, message) in bad) {
            recording.writeLines(lines)
            val error = assertThrows<InputError> { twin.picture(recording, ContextKind.OSMESA) }
            assertTrue(message in error.message.orEmpty()) { "${error.message}" }
        }
        assertTrue(!folder.resolve("twin.rgba").exists())
    }

    private fun record(
        kind: ContextKind,
        shot: TwinShot,
    ): RecordedFrame = Offscreen.openOrSkip(kind).use { RecordedFrame.of(shot) }

    private fun assertSame(
        ours: ImageData,
        twins: ImageData,
        what: String,
    ) {
        assertEquals(ours.width to ours.height, twins.width to twins.height, what)
        assertTrue(ours.rgba.any { it != ours.rgba[0] }) { "$what is empty" }
        assertArrayEquals(ours.rgba, twins.rgba, what)
    }

    private fun rootMeanSquare(
        a: ImageData,
        b: ImageData,
    ): Double {
        fun levels(image: ImageData) = image.rgba.map { it.toInt() and 0xFF }
        return sqrt(levels(a).zip(levels(b)) { x, y -> ((x - y) * (x - y)).toDouble() }.average())
    }
}
