package cga.inspect

import cga.exercise.game.RunningGame
import cga.framework.image.ImageData
import cga.testing.CgaProcess.Companion.cga
import cga.testing.OnXvfb
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
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.math.abs

/** The inspector in the real window: another process on a virtual display, keys and mouse from outside, and what the screen shows. */
@ExtendWith(OnXvfb::class)
@Slow
class InspectedWindowTest(private val display: Xvfb) {
    @TempDir
    private lateinit var directory: Path

    @Test
    fun `what F9 saved replays off screen to the pictures that F12 saved, the dragged divider too, and always to the same bytes`() {
        play("--samples 0") { game, run ->
            game.holding("w") { Thread.sleep(300) }
            game.moveMouse(120)
            val first = game.screenshot()
            game.press("5")
            game.holding("a") { game.holding("w") { Thread.sleep(200) } }
            game.press("b")
            val second = game.screenshot()
            for (key in listOf("f", "g", "p")) game.press(key)
            game.drag(150)
            val third = game.screenshot()
            game.press("F9")
            val recording = run.resolve("recording-001.txt")
            game.await("the recording") { recording.takeIf { it.exists() } }
            val lines = recording.readText().lines()
            val half = 0.5f + 150f / WIDTH
            assertTrue(lines.any { it.endsWith("turn divider $half") }) { "the divider was not dragged to $half: $lines" }
            // The mouse that moves the divider does not turn the camera.
            assertTrue(lines.indexOfLast { " mouse " in it } < lines.indexOfFirst { "turn split" in it }) { "$lines" }
            val out = run.resolve("replayed.png")
            val words = "replay $recording --pictures --samples 0 --size ${WIDTH}x$HEIGHT --out $out".split(' ').toTypedArray()
            val process = cga(*words, directory = run)
            assertEquals(0, process.exitCode, "$process")
            assertEquals(0, cga(*words.dropLast(1).toTypedArray(), "${run.resolve("again.png")}", directory = run).exitCode)
            for ((i, picture) in listOf(first, second, third).withIndex()) {
                val file = run.resolve("replayed-000${i + 1}.png")
                assertSimilar(picture, ImageData.read("$file"))
                val again = run.resolve("again-000${i + 1}.png")
                assertArrayEquals(file.readBytes(), again.readBytes(), "picture ${i + 1}")
            }
            assertFalse(first.rgba.contentEquals(second.rgba))
        }
    }

    @Test
    fun `a shader that is saved is taken by itself, and an error in it is told on the screen while the old one goes on`() {
        val home = Files.createTempDirectory(directory, "home")
        for (folder in listOf("shaders", "assets")) projectRoot.resolve(folder).copyRecursively(home.resolve(folder).toFile())
        val shader = home.resolve("shaders/scene.frag")
        val good = shader.readText()
        play("--step 4.1 --samples 0", home) { game, _ ->
            val before = game.screenshot()
            shader.writeText(good.replace("void main() {\n", "void main() {\n    oops = 1.0;\n"))
            game.await("the error") { game.err.takeIf { Regex("""shaders/scene\.frag:\d+: .*oops""") in it } }
            assertArrayEquals(before.rgba, game.screenshot().rgba, "the old shader's picture")
            game.awaitScreen("the error on the screen") { bright(it, ERROR) > ERROR_PIXELS }

            shader.writeText(good.replace("fragColor = vec4(", "fragColor = vec4(0.2, 0.4, 0.6, 1.0); vec4 unused = vec4("))
            game.await("the new shader") { true.takeIf { "shaders reloaded" in game.out } }
            val ground = game.screenshot()
            val pixel = 4 * ((HEIGHT - 1) * WIDTH)
            assertEquals(listOf(51, 102, 153), List(3) { ground.rgba[pixel + it].toInt() and 0xFF })
            game.awaitScreen("the error gone") { bright(it, ERROR) == 0 }
        }
    }

    @Test
    fun `a dark picture lists its causes on the screen`() {
        val home = Files.createTempDirectory(directory, "home")
        for (folder in listOf("shaders", "assets")) projectRoot.resolve(folder).copyRecursively(home.resolve(folder).toFile())
        val shader = home.resolve("shaders/scene.frag")
        shader.writeText(shader.readText().replace("fragColor = vec4(", "fragColor = sqrt(-1.0 - emissive.r) * vec4("))
        play("--samples 0", home) { game, _ ->
            game.awaitScreen("the causes") { bright(it, CAUSE) > ERROR_PIXELS }
        }
    }

    @Test
    fun `Tab opens the panel and lets the mouse go, a click tells the numbers of a pixel, Tab closes both`() {
        play("--step 4.3.4 --samples 0") { game, _ ->
            // Twice the same: a screen that is read while a frame is put on it shows parts of two.
            val plain =
                game.await("the scene") {
                    val (first, second) = List(2) { display.screen(WIDTH, HEIGHT) }
                    // Without the hint of the start, whose words are in this colour.
                    first.takeIf { bright(it, GRID) > 100 && bright(it, GOOD) == 0 && it.rgba.contentEquals(second.rgba) }
                }
            game.press("Tab")
            game.awaitScreen("the panel") { bright(it, ACCENT) > 50 }
            game.await("the probe") {
                // On the ground, left of the panel.
                display.clickAt(200, 100)
                true.takeIf { bright(display.screen(WIDTH, HEIGHT), GOOD) > 50 }
            }
            game.press("Tab")
            game.awaitScreen("the scene without panels") { it.rgba.contentEquals(plain.rgba) }
        }
    }

    @Test
    fun `on a display with two pixels to a unit everything is twice as fine and in its place`() {
        val run = Files.createTempDirectory(directory, "run")
        val fine = mapOf("JAVA_TOOL_OPTIONS" to "-Dcga.pixelRatio=2")
        Xvfb.openOrSkip("2240x800").use { wide ->
            RunningGame(wide, run, "--step 4.3.4 --samples 0 --size 1100x380", variables = fine).use { game ->
                val picture = game.screenshot()
                val file = run.resolve("off.png")
                assertEquals(0, cga("render", "--step", "4.3.4", "--size", "2200x760", "--out", "$file", directory = run).exitCode)
                assertSimilar(ImageData.read("$file"), picture)

                // Between the two panels, whose places are known: the cross is where the mouse is, and nowhere else is its colour.
                game.press("Tab")
                game.await("the panel") { true.takeIf { bright(wide.screen(2200, 760), ACCENT) > 50 } }
                game.await("the cross at the mouse") {
                    wide.clickAt(1100, 400)
                    val cross = places(wide.screen(2200, 760), CAUSE).filter { (x, _) -> x in 800..1440 }
                    cross.takeIf { it.size > 40 && it.all { (x, y) -> abs(x - 1101) <= 26 && abs(y - 401) <= 26 } }
                }
            }
        }
    }

    /** To be done until it shows: the window puts the cursor back to where it was hidden, and that takes as long as it takes. */
    private fun Xvfb.clickAt(x: Int, y: Int) {
        // GLFW passes over a movement to just where it has put the cursor itself.
        xdotool("mousemove ${x + 1} ${y + 1}")
        xdotool("mousemove $x $y")
        xdotool("click 1")
    }

    private fun RunningGame.awaitScreen(what: String, isSo: (ImageData) -> Boolean) {
        await(what) { true.takeIf { isSo(display.screen(WIDTH, HEIGHT)) } }
    }

    private fun play(options: String, home: Path = projectRoot.toPath(), test: (RunningGame, Path) -> Unit) {
        val run = Files.createTempDirectory(directory, "run")
        RunningGame(display, run, "$options --size ${WIDTH}x$HEIGHT", home).use { test(it, run) }
    }

    /** A window's picture is drawn upside down to a framebuffer's, so at edges a few samples fall to the other side. */
    private fun assertSimilar(expected: ImageData, actual: ImageData) {
        val different = expected.rgba.indices.count { abs((expected.rgba[it].toInt() and 0xFF) - (actual.rgba[it].toInt() and 0xFF)) > 2 }
        assertTrue(different <= expected.rgba.size / 100) { "$different of ${expected.rgba.size} numbers differ by more than 2" }
    }

    /** How many pixels have about this colour, 0xRRGGBB: letters of a panel, whose edges mix with what is behind. */
    private fun bright(screen: ImageData, color: Int): Int = (0 until screen.width * screen.height).count { isNear(screen, it, color) }

    private fun places(screen: ImageData, color: Int): List<Pair<Int, Int>> =
        (0 until screen.width * screen.height).filter { isNear(screen, it, color) }.map { it % screen.width to it / screen.width }

    private fun isNear(screen: ImageData, pixel: Int, color: Int) =
        (0..2).all { abs((screen.rgba[4 * pixel + it].toInt() and 0xFF) - (color shr (16 - 8 * it) and 0xFF)) < 50 }

    private companion object {
        const val WIDTH = 800
        const val HEIGHT = 450
        const val ERROR = 0xFF6B6B
        const val CAUSE = 0xFFC857
        const val ACCENT = 0x37C871
        const val GOOD = 0x5BE495

        /** The middle of a grid line at the steps without colour. */
        const val GRID = 0xFFFFFF
        const val ERROR_PIXELS = 100
    }
}
