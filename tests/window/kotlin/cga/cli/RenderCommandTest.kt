package cga.cli

import cga.exercise.game.Step
import cga.framework.context.ContextKind
import cga.framework.image.ImageData
import cga.framework.image.readExr
import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.math.abs

/** `cga render` as a process: what its options make of the picture, and which files it leaves. */
@Slow
class RenderCommandTest {
    @TempDir
    private lateinit var folder: Path

    @BeforeEach
    fun `there is a context`() = Offscreen.openOrSkip().close()

    @Test
    fun `without options it is the final picture as motorcycle png`() {
        render()
        assertFiles("motorcycle.png")
        val picture = read("motorcycle.png")
        assertEquals(1280 to 720, picture.width to picture.height)
        assertTrue(picture.rgba.toSet().size > 100, "too few different bytes for a picture")
    }

    @Test
    fun `all options together give a PNG and an OpenEXR of the same picture`() {
        render(
            "--step", "4.6", "--size", "64x36", "--t", "2.5", "--mouse", "-300", "--drive", "W 0.5, WA 0.5", "--samples", "4",
            "--specular", "blinn-phong", "--gamma", "2.2", "--context", "osmesa", "--out", "a.png", "--float", "a.exr",
        )
        assertFiles("a.exr", "a.png")
        val picture = read("a.png")
        val floats = readExr("a.exr", 64, 36)
        assertEquals(64 to 36, picture.width to picture.height)
        for (i in floats.indices) {
            // OpenGL 3.3, 2.1.5: an integer is made of 255·f, here the nearest; the product itself errs by a float's 2⁻²⁴ of 255.
            val error = abs(floats[i].coerceIn(0f, 1f) * 255.0 - (picture.rgba[i].toInt() and 0xFF))
            assertTrue(error <= 0.5 + 255.0 / (1 shl 24), "number $i: ${floats[i]} and ${picture.rgba[i].toInt() and 0xFF}")
        }
    }

    @Test
    fun `float alone is OpenEXR alone, brighter than a screen`() {
        render("--size", "64x36", "--float", "a.exr")
        assertFiles("a.exr")
        assertArrayEquals(byteArrayOf(0x76, 0x2F, 0x31, 0x01), folder.resolve("a.exr").readBytes().copyOf(4))
        assertTrue(readExr("a.exr", 64, 36).max() > 1f)
    }

    @Test
    fun `every option has its effect`() {
        val options =
            listOf(
                listOf(), listOf("--step", "4.5"), listOf("--t", "1"), listOf("--mouse", "100"), listOf("--drive", "W 0.5", "--t", "5.3"),
                listOf("--samples", "4"), listOf("--specular", "phong"), listOf("--gamma", "2.2"),
            )
        val pictures =
            options.map {
                render("--size", "64x36", "--out", "a.png", *it.toTypedArray())
                folder.resolve("a.png").readBytes().toList()
            }
        for (a in options.indices) for (b in 0 until a) assertTrue(pictures[a] != pictures[b], "${options[a]} is as ${options[b]}")
        assertFiles("a.png")
    }

    @Test
    fun `before the orbit the mouse is said to have no effect`() {
        val process = render("--step", "4.4", "--mouse", "10", "--size", "16x9")
        assertTrue("--mouse" in process.err && Step.ORBIT.sheet in process.err, "$process")
    }

    @Test
    fun `a sequence is numbered, and each of its pictures is the single one of its time and mouse`() {
        render("--frames", "3", "--fps", "2", "--t", "1", "--mouse", "200", "--size", "32x18", "--out", "s.png", "--float", "s.exr")
        assertFiles("s-0001.exr", "s-0001.png", "s-0002.exr", "s-0002.png", "s-0003.exr", "s-0003.png")
        render("--t", "1.5", "--mouse", "100", "--size", "32x18", "--out", "single.png", "--float", "single.exr")
        assertArrayEquals(folder.resolve("single.png").readBytes(), folder.resolve("s-0002.png").readBytes())
        assertArrayEquals(folder.resolve("single.exr").readBytes(), folder.resolve("s-0002.exr").readBytes())
        assertEquals(3, listOf(1, 2, 3).map { folder.resolve("s-000$it.png").readBytes().toList() }.toSet().size)
    }

    @Test
    fun `an animation is one file, whose first picture is the still one`() {
        render("--frames", "3", "--fps", "2", "--t", "1", "--mouse", "200", "--size", "32x18", "--out", "s.apng")
        render("--t", "1", "--size", "32x18", "--out", "single.png")
        assertFiles("s.apng", "single.png")
        // Readers that know nothing of animation see the first picture.
        assertArrayEquals(read("single.png").rgba, read("s.apng").rgba)
        val chunks = folder.resolve("s.apng").readBytes().toString(Charsets.ISO_8859_1)
        assertEquals(listOf(1, 3, 2), listOf("acTL", "fcTL", "fdAT").map { it.toRegex().findAll(chunks).count() })
        val refused = cga("render", "--out", "s.apng", "--float", "a.exr")
        assertEquals(2, refused.exitCode, "$refused")
        assertTrue("--float" in refused.err, "$refused")
    }

    @Test
    fun `each context that works gives a picture`() {
        for (kind in listOf(ContextKind.OSMESA, ContextKind.EGL)) {
            Offscreen.openOrSkip(kind).close()
            render("--context", kind.name.lowercase(), "--size", "16x9", "--out", "${kind.name}.png")
        }
        assertFiles("EGL.png", "OSMESA.png")
        assertArrayEquals(folder.resolve("EGL.png").readBytes(), folder.resolve("OSMESA.png").readBytes())
    }

    @Test
    fun `run without a display renders to motorcycle png and says so`() {
        assumeTrue(System.getProperty("os.name").startsWith("Linux"))
        val process = cga("run", "--size", "32x18", "--step", "4.2")
        assertEquals(0, process.exitCode, "$process")
        assertTrue("no display" in process.err && "motorcycle.png" in process.err, "$process")
        assertFiles("motorcycle.png")
        assertEquals(32, read("motorcycle.png").width)
    }

    @Test
    fun `help is no error, and help instead of a command is`() {
        val help = cga("--help")
        assertEquals(0, help.exitCode, "$help")
        for (command in listOf("run", "render", "doctor")) assertTrue(command in help.out, "$help")
        val ofRender = cga("render", "--help")
        assertEquals(0, ofRender.exitCode, "$ofRender")
        val options =
            listOf("step", "size", "t", "mouse", "drive", "samples", "out", "float", "context", "frames", "fps", "gamma", "specular")
        for (option in options) assertTrue("--$option" in ofRender.out, "--$option: $ofRender")
        val none = cga()
        assertEquals(2, none.exitCode, "$none")
        assertTrue("Usage: cga" in none.out + none.err, "$none")
        assertFiles()
    }

    private fun render(vararg options: String): CgaProcess =
        cga("render", *options).also { assertEquals(0, it.exitCode, "${options.toList()}: $it") }

    private fun cga(vararg args: String): CgaProcess =
        CgaProcess.cga(*args, directory = folder, env = mapOf("DISPLAY" to null, "WAYLAND_DISPLAY" to null))

    private fun assertFiles(vararg names: String) = assertEquals(names.toList(), folder.listDirectoryEntries().map { it.name }.sorted())

    private fun read(name: String): ImageData = ImageData.read("${folder.resolve(name)}")

    private fun readExr(
        name: String,
        width: Int,
        height: Int,
    ): FloatArray {
        val image = readExr(folder.resolve(name))
        assertEquals(width to height, image.width to image.height)
        return image.rgba
    }
}
