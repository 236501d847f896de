package cga.cli

import cga.framework.image.ImageData
import cga.framework.image.readExr
import cga.testing.CgaProcess
import cga.testing.Slow
import cga.testing.withoutOpenGL
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.math.abs

/** `cga render --context reference`, on a machine that hides its OpenGL. */
@Slow
class ReferenceRenderTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `without OpenGL it gives PNG and OpenEXR of the same picture, and no class of OpenGL or GLFW is loaded`() {
        val classes = folder.resolve("classes.log")
        val process = render("--out", "a.png", "--float", "a.exr", env = mapOf("JDK_JAVA_OPTIONS" to "-Xlog:class+load:file=$classes"))
        assertEquals(0, process.exitCode, "$process")
        val picture = ImageData.read("${folder.resolve("a.png")}")
        val floats = readExr(folder.resolve("a.exr"))
        assertEquals(64 to 36, picture.width to picture.height)
        assertTrue(picture.rgba.toSet().size > 100, "too few different bytes for a picture")
        for (i in floats.rgba.indices) {
            // A byte is the nearest one; the float beside it was rounded too.
            assertEquals(floats.rgba[i].coerceIn(0f, 1f) * 255.0, (picture.rgba[i].toInt() and 0xFF).toDouble(), 0.5 + 255.0 / (1 shl 24))
        }
        val loaded = classes.readLines().filter { line -> listOf("opengl", "glfw", "egl").any { "org.lwjgl.$it." in line } }
        assertTrue(classes.readText().contains("cga.reference.ReferenceRenderer"), "the log shows no class of the reference")
        assertEquals(emptyList<String>(), loaded)
    }

    @Test
    fun `all options have their effect on it`() {
        val options =
            listOf(
                listOf(), listOf("--step", "4.5"), listOf("--t", "1"), listOf("--mouse", "100"), listOf("--samples", "4"),
                listOf("--samples", "16"), listOf("--specular", "phong"), listOf("--gamma", "2.2"),
            )
        val pictures =
            options.map {
                val process = render("--out", "a.png", *it.toTypedArray())
                assertEquals(0, process.exitCode, "$it: $process")
                ImageData.read("${folder.resolve("a.png")}").rgba.toList()
            }
        for (a in options.indices) for (b in 0 until a) assertTrue(pictures[a] != pictures[b], "${options[a]} is as ${options[b]}")
        // 2×2 and 4×4 samples are two approximations of one picture.
        val difference = pictures[4].indices.map { abs((pictures[4][it].toInt() and 0xFF) - (pictures[5][it].toInt() and 0xFF)) }.average()
        assertTrue(difference < 5, "mean difference $difference")
    }

    @Test
    fun `other numbers of samples are refused by name`() {
        for (samples in listOf("1", "2", "8", "9")) {
            val process = render("--out", "a.png", "--samples", samples)
            assertEquals(2, process.exitCode, "$process")
            assertTrue("--samples $samples" in process.err && "0, 4, 16" in process.err, "$process")
        }
        val large = render("--out", "a.png", "--size", "99999x99999")
        assertEquals(2, large.exitCode, "$large")
        assertTrue("99999x99999" in large.err, "$large")
    }

    private fun render(vararg options: String, env: Map<String, String?> = emptyMap()): CgaProcess {
        val size = if ("--size" in options) emptyArray() else arrayOf("--size", "64x36")
        val args = arrayOf("render", "--context", "reference") + size + options
        return CgaProcess.cga(*args, directory = folder, env = withoutOpenGL(folder.resolve("lib${libraries++}").createDirectory()) + env)
    }

    private var libraries = 0
}
