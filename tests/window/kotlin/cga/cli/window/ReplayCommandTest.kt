package cga.cli.window

import cga.framework.image.ImageData
import cga.testing.CgaProcess
import cga.testing.NO_DISPLAY
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.writeText

/** `cga replay` as a process: what it makes of a recording, and what it says of something else. */
@Slow
class ReplayCommandTest {
    @TempDir
    private lateinit var folder: Path

    @BeforeEach
    fun `there is a context`() = Offscreen.openOrSkip().close()

    @Test
    fun `without options it is an animation, as long as the recording`() {
        record("0 mouse 0.0", "0 hold W", "10 mouse 40.0", "24 end")
        replay()
        assertEquals(listOf("recording.txt", "replay.apng"), files())
        // A quarter of the 24 updates of 1/120 s have a picture, and so has the start.
        assertEquals(7, count(folder.resolve("replay.apng").readBytes(), "fcTL"))
    }

    @Test
    fun `pictures are those of F12, and what is turned is seen in them`() {
        record("30 picture", "30 turn view 3.0", "30 picture", "30 turn scene.gamma 2.0", "30 turn view 0.0", "40 picture", "40 end")
        replay("--pictures", "--out", "p.png")
        assertEquals(listOf("p-0001.png", "p-0002.png", "p-0003.png", "recording.txt"), files())
        val pictures = (1..3).map { folder.resolve("p-000$it.png").readBytes() }
        assertEquals(3, pictures.map { it.toList() }.toSet().size)
        assertEquals(64, ImageData.read("${folder.resolve("p-0001.png")}").width)

        // The first is what render draws of that time.
        val words = listOf("render", "--t", "0.25", "--samples", "4", "--size", "64x36", "--out", "r.png").toTypedArray()
        val render = CgaProcess.cga(*words, directory = folder, env = NO_DISPLAY)
        assertEquals(0, render.exitCode, "$render")
        assertArrayEquals(ImageData.read("${folder.resolve("r.png")}").rgba, ImageData.read("${folder.resolve("p-0001.png")}").rgba)
    }

    @Test
    fun `what cannot be replayed is one message and exit code 2`() {
        record("0 end")
        refuse("0 pictures: from 1", "--pictures")
        refuse("--fps 0.0", "--fps", "0")
        folder.resolve("recording.txt").writeText("cga recording 1, step 4.7\n0 end\n")
        refuse("format 1")
        folder.resolve("recording.txt").writeText("hello\n")
        refuse("does not begin with")
        record("0 turn pointLight.wattage 60.0", "0 end")
        refuse("pointLight.wattage")
        folder.resolve("recording.txt").toFile().delete()
        refuse("recording.txt")
        assertEquals(emptyList<String>(), files())
    }

    private fun refuse(
        part: String,
        vararg options: String,
    ) {
        val process = process(*options)
        assertEquals(2, process.exitCode, "$process")
        val message = process.err.replace(Regex("\\s+"), " ")
        assertTrue(part in message, "$process")
        assertTrue("\tat " !in process.err, "$process")
    }

    private fun record(vararg lines: String) =
        folder.resolve("recording.txt").writeText((listOf("cga recording 2, step 4.7") + lines).joinToString("\n", postfix = "\n"))

    private fun replay(vararg options: String) = process(*options).also { assertEquals(0, it.exitCode, "$it") }

    private fun process(vararg options: String) =
        CgaProcess.cga("replay", "recording.txt", "--size", "64x36", *options, directory = folder, env = NO_DISPLAY)

    private fun files() = folder.listDirectoryEntries().map { it.name }.sorted()

    private fun count(
        bytes: ByteArray,
        chunk: String,
    ) = chunk.toRegex().findAll(bytes.toString(Charsets.ISO_8859_1)).count()
}
