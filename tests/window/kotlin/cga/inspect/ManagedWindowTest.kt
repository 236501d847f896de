package cga.inspect

import cga.exercise.game.RunningGame
import cga.framework.image.ImageData
import cga.testing.CgaProcess.Companion.cga
import cga.testing.OnXvfb
import cga.testing.Openbox
import cga.testing.OtherWindow
import cga.testing.Slow
import cga.testing.Xvfb
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.abs

/** The real window under a window manager: whatever that does to it, it goes on with the same picture, and tells no OpenGL error. */
@ExtendWith(OnXvfb::class)
@Slow
class ManagedWindowTest(private val display: Xvfb) {
    @TempDir
    private lateinit var directory: Path

    @Test
    fun `minimised and restored it shows what it showed, and answers`() {
        playPaused { game, turned ->
            game.minimise()
            assertFalse(display.shows(turned))
            game.activate()
            game.await("the picture of before") { true.takeIf { display.shows(turned) } }
            assertUnturned(game, turned)
        }
    }

    @Test
    fun `while another window has the keyboard, keys and mouse are not its own, and afterwards nothing has jumped`() {
        playPaused { game, turned ->
            OtherWindow.start(display).use {
                display.xdotool("mousemove 700 420")
                for (key in listOf("1", "w", "Escape")) game.press(key)
            }
            game.activate()
            assertUnturned(game, turned)
        }
    }

    @Test
    fun `the mouse that stayed inside turns nothing when the keyboard comes back`() {
        playPaused { game, turned ->
            OtherWindow.start(display).close()
            game.activate()
            assertUnturned(game, turned)
        }
    }

    @Test
    fun `resized, by a pixel of width and height too, it draws the picture of its size`() {
        play("--step 4.3.4") { game ->
            for (size in listOf(1 to 1, 900 to 500, 320 to 400)) {
                game.resize(size)
                val picture = game.await("a picture of $size") { game.screenshot().takeIf { it.width to it.height == size } }
                assertSimilar(render(size), picture)
                if (size.first > 1) game.await("it on the screen") { true.takeIf { display.shows(picture) } }
                // The panel, too, has to live with any size.
                repeat(2) { game.press("Tab") }
            }
        }
    }

    /** The time stands still, and the camera is turned: [test] is given the picture. */
    private fun playPaused(test: (RunningGame, ImageData) -> Unit) =
        play("--step 4.7") { game ->
            game.press("p")
            val start = game.screenshot()
            game.moveMouse(TURN)
            val turned = game.screenshot()
            assertFalse(turned.rgba.contentEquals(start.rgba))
            test(game, turned)
        }

    /** It shows [turned], and answers the mouse. */
    private fun assertUnturned(
        game: RunningGame,
        turned: ImageData,
    ) {
        assertArrayEquals(turned.rgba, game.screenshot().rgba, "the camera jumped")
        game.moveMouse(-TURN)
        assertFalse(turned.rgba.contentEquals(game.screenshot().rgba), "it does not answer")
        game.moveMouse(TURN)
        assertArrayEquals(turned.rgba, game.screenshot().rgba, "the way back is another")
    }

    private fun play(
        options: String,
        test: (RunningGame) -> Unit,
    ) {
        Openbox.startOrSkip(display).use {
            RunningGame(display, directory, "$options --samples 0 --size ${WIDTH}x$HEIGHT", projectRoot.toPath()).use { game ->
                test(game)
                assertFalse("OpenGL" in game.err, game.err)
                game.press("Escape")
                assertEquals(0, game.exitCode())
            }
        }
    }

    private fun render(size: Pair<Int, Int>): ImageData {
        val file = directory.resolve("off.png")
        val words = "render --step 4.3.4 --size ${size.first}x${size.second} --out $file".split(' ').toTypedArray()
        val process = cga(*words, directory = directory)
        assertEquals(0, process.exitCode) { "$process" }
        return ImageData.read("$file")
    }

    /** A window's picture is drawn upside down to a framebuffer's, so at edges a few samples fall to the other side. */
    private fun assertSimilar(
        expected: ImageData,
        actual: ImageData,
    ) {
        val different = expected.rgba.indices.count { abs((expected.rgba[it].toInt() and 0xFF) - (actual.rgba[it].toInt() and 0xFF)) > 2 }
        assertTrue(different <= expected.rgba.size / 100) { "$different of ${expected.rgba.size} numbers differ by more than 2" }
    }

    private companion object {
        const val WIDTH = 640
        const val HEIGHT = 360
        const val TURN = 40
    }
}
