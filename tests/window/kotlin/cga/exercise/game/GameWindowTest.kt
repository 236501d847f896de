package cga.exercise.game

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
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.math.abs

/** The real window: another process on a virtual display, its keys pressed and its mouse moved from outside, its pictures compared. */
@ExtendWith(OnXvfb::class)
@Slow
class GameWindowTest(private val display: Xvfb) {
    @TempDir
    private lateinit var directory: Path

    @Test
    fun `number keys choose the step, B the specular model, Esc quits`() {
        play("--samples 0") { game ->
            val final = game.screenshot()
            assertTrue("4.7" in game.title, game.title)

            game.press("1")
            val emission = game.screenshot()
            assertTrue("4.1" in game.title, game.title)
            assertSimilar(render("--step 4.1"), emission)
            assertTrue(difference(emission, final) > 2 * SIMILAR) { "step 4.1 looks like 4.7" }

            // The last step without time in its picture.
            game.press("4")
            val phong = game.screenshot()
            assertSimilar(render("--step 4.3.4"), phong)
            game.press("b")
            val blinnPhong = game.screenshot()
            assertTrue("Blinn-Phong" in game.title, game.title)
            assertSimilar(render("--step 4.3.4 --specular blinn-phong"), blinnPhong)
            assertTrue(difference(blinnPhong, phong) > 2 * SIMILAR) { "Blinn-Phong looks like Phong" }
            game.press("b")
            assertSame(phong, game.screenshot())

            game.moveMouse(100)
            assertSame(phong, game.screenshot())

            game.press("Escape")
            assertEquals(0, game.exitCode())
        }
    }

    @Test
    fun `the mouse turns the camera by its way and never makes it jump`() {
        val home = homeOfStillPictures()
        display.xdotool("mousemove 1200 700")
        play("--samples 0", home) { game ->
            val still = game.screenshot()
            assertSimilar(render("--mouse 0", home), still)
            game.moveMouse(100)
            assertSimilar(render("--mouse 100", home), game.screenshot())
            game.moveMouse(-250)
            val turned = game.screenshot()
            assertSimilar(render("--mouse -150", home), turned)

            game.loseFocusAndRegainIt()
            assertSame(turned, game.screenshot())
            game.moveMouse(150)
            assertSimilar(still, game.screenshot())
        }
    }

    @Test
    fun `W drives as long as it is held, and the camera with it`() {
        play("--step 4.1") { game ->
            val start = game.screenshot()
            game.holding("w") { game.await("the ground's far edge nearer") { game.screenshot().takeIf { horizon(it) > horizon(start) } } }
            val end = game.screenshot()
            assertSame(end, game.screenshot())
            // All of it motorcycle.
            for (y in 150..190) {
                for (x in 310..330) assertTrue(distance(start, end, y * WIDTH + x) <= ROUNDING) { "the motorcycle changed at $x, $y" }
            }
        }
    }

    @Test
    fun `R takes a new shader, and keeps the old one where the new one is wrong`() {
        val home = copyOfHome()
        val shader = home.resolve("shaders/scene.frag")
        val good = shader.readText()
        val line = good.lines().indexOf("void main() {") + 2
        play("--step 4.1", home) { game ->
            val before = game.screenshot()
            shader.writeText(good.replace("void main() {\n", "void main() {\n    oops = 1.0;\n"))
            game.press("r")
            assertSame(before, game.screenshot())
            assertTrue(Regex("""shaders/scene\.frag:$line: .*oops.*\n {4}oops = 1\.0;\n""") in game.err, game.err)
            assertEquals("", game.out.lines().filter { "reloaded" in it }.joinToString())

            shader.writeText(good.replace(FINAL_COLOR, "fragColor = vec4(0.2, 0.4, 0.6, 1.0);"))
            game.press("r")
            val ground = game.screenshot()
            assertEquals(listOf(51, 102, 153), List(3) { ground.channel((HEIGHT - 1) * WIDTH, it) })
            assertTrue("shaders reloaded" in game.out, game.out)

            shader.writeText(good)
            game.press("r")
            assertSame(before, game.screenshot())
        }
    }

    @Test
    fun `a resized window shows the picture of its new size, not the old one stretched`() {
        play("--step 4.1 --samples 0") { game ->
            for (size in listOf(801 to 300, 300 to 501)) {
                game.resize(size)
                val picture = game.await("a picture of $size") { game.screenshot().takeIf { it.width to it.height == size } }
                assertSimilar(render("--step 4.1", size = size), picture)
                assertShown(game, picture)
            }
        }
    }

    @Test
    fun `with several samples a pixel the picture is smooth, and F12 saves what the screen shows`() {
        play("--step 4.1 --samples 4") { game ->
            val picture = game.screenshot()
            assertShown(game, picture)
            // A window's samples lie upside down to a framebuffer's, so at edges they differ: measured 0.056, and 0.147 from the jagged one.
            val smooth = mean(picture, render("--step 4.1 --samples 4"))
            val jagged = mean(picture, render("--step 4.1 --samples 0"))
            assertTrue(smooth < jagged / 2) { "off by $smooth from the smooth picture, by $jagged from the jagged one" }
        }
    }

    @Test
    fun `a window that cannot be is one message that says why`() {
        val named = mapOf("--size 100000x100" to "100000x100", "--samples 99" to "99 samples", "--samples -1" to "-1 samples")
        for ((options, name) in named) {
            val words = "run $options".split(' ').toTypedArray()
            val process = cga(*words, directory = directory, env = display.variables)
            assertEquals(2, process.exitCode) { "$process" }
            assertEquals(listOf(true), process.err.lines().filter { it.startsWith("cga: ") }.map { name in it }) { "$process" }
            assertFalse("Exception" in process.err) { "$process" }
        }
    }

    private fun play(
        options: String,
        home: Path = projectRoot.toPath(),
        test: (RunningGame) -> Unit,
    ) {
        val run = Files.createTempDirectory(directory, "run")
        RunningGame(display, run, "$options --size ${WIDTH}x$HEIGHT", home).use(test)
    }

    /** The same off screen. */
    private fun render(
        options: String,
        home: Path = projectRoot.toPath(),
        size: Pair<Int, Int> = WIDTH to HEIGHT,
    ): ImageData {
        val file = Files.createTempDirectory(directory, "render").resolve("picture.png")
        val words = "render --size ${size.first}x${size.second} --out $file $options".split(' ').toTypedArray()
        val process = cga(*words, directory = directory, home = home)
        assertEquals(0, process.exitCode) { process.toString() }
        return ImageData.read(file.toString())
    }

    /** A copy of shaders and assets, to be changed. */
    private fun copyOfHome(): Path {
        val home = Files.createTempDirectory(directory, "home")
        for (folder in listOf("shaders", "assets")) projectRoot.resolve(folder).copyRecursively(home.resolve(folder).toFile())
        return home
    }

    /** Every step shows only the emissive textures, unfiltered by distance: nothing in its pictures depends on the time. */
    private fun homeOfStillPictures(): Path {
        val home = copyOfHome()
        val shader = home.resolve("shaders/scene.frag")
        val still = "fragColor = vec4(textureLod(material.emissive, surfaceTexCoord, 0.0).rgb, 1.0);"
        shader.writeText(shader.readText().replace(FINAL_COLOR, still).also { check(still in it) })
        return home
    }

    /** The window's own pixels on the screen are those of [picture]. */
    private fun assertShown(
        game: RunningGame,
        picture: ImageData,
    ) {
        game.await("F12's picture on the screen") {
            picture.takeIf { display.screen(it.width, it.height).rgba.contentEquals(it.rgba) }
        }
    }

    private fun assertSame(
        expected: ImageData,
        actual: ImageData,
    ) {
        assertArrayEquals(expected.rgba, actual.rgba)
    }

    /** One scene on one machine: what differs is rounding, since a window's rows run upwards where a framebuffer's run downwards. */
    private fun assertSimilar(
        expected: ImageData,
        actual: ImageData,
    ) {
        val difference = difference(expected, actual)
        assertTrue(difference <= SIMILAR) { "$difference of the pixels differ by more than $ROUNDING, and not at most $SIMILAR" }
    }

    /** The share of the pixels that differ by more than [ROUNDING]. */
    private fun difference(
        a: ImageData,
        b: ImageData,
    ): Double {
        assertEquals(a.width to a.height, b.width to b.height)
        val pixels = a.width * a.height
        return (0 until pixels).count { distance(a, b, it) > ROUNDING } / pixels.toDouble()
    }

    private fun distance(
        a: ImageData,
        b: ImageData,
        pixel: Int,
    ): Int = (0..2).maxOf { abs(a.channel(pixel, it) - b.channel(pixel, it)) }

    private fun mean(
        a: ImageData,
        b: ImageData,
    ): Double = (0 until a.width * a.height).sumOf { distance(a, b, it) } / (a.width * a.height).toDouble()

    /** The first row from above that is not black. */
    private fun horizon(picture: ImageData): Int =
        (0 until picture.width * picture.height).first { pixel -> (0..2).any { picture.channel(pixel, it) > 0 } } / picture.width

    private fun ImageData.channel(
        pixel: Int,
        channel: Int,
    ): Int = rgba[4 * pixel + channel].toInt() and 0xFF

    private companion object {
        const val WIDTH = 640
        const val HEIGHT = 360
        const val ROUNDING = 2

        // Measured at most 0.0031; one pixel of mouse makes 0.20, Phong instead of Blinn-Phong 0.027.
        const val SIMILAR = 0.01
        val FINAL_COLOR = Regex("fragColor = [^;]*;")
    }
}
