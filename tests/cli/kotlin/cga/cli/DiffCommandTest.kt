package cga.cli

import cga.framework.image.ExrFile
import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.framework.image.PngFile
import cga.testing.CgaProcess
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** `cga diff` as its users start it. */
@Slow
class DiffCommandTest {
    @TempDir
    private lateinit var folder: Path

    @BeforeEach
    fun `draw pictures`() {
        PngFile.write(picture(WIDTH, HEIGHT), folder.resolve("a.png"))
        PngFile.write(picture(WIDTH, HEIGHT, change = 3), folder.resolve("b.png"))
        PngFile.write(picture(HEIGHT, WIDTH), folder.resolve("turned.png"))
    }

    @Test
    fun `equal pictures end with 0`() {
        val process = diff("a.png", "a.png")
        assertEnd(process, 0)
        assertEquals("identical: 40x30, 8 bits a channel, RGB", process.out.trim())
    }

    @Test
    fun `pictures that differ end with 1 and all figures`() {
        val process = diff("a.png", "b.png", "--map", "map.png")
        assertEnd(process, 1)
        // 256 of 1200 pixels differ by 3 in red: rmse = 3/255·√(256/3600), and the window that is all of them has the mean 3/255.
        val rows = rows(process.out)
        assertEquals("red 3/255 · green 0 · blue 0", rows["Largest difference"])
        assertEquals("256 of 1,200 (21.33 %)", rows["Pixels that differ"])
        assertEquals("0.003137 (0.8/255)", rows["RMSE"])
        assertEquals("50.07 dB", rows["PSNR"])
        assertEquals("mean 3/255, at 20, 10", rows["Worst 16×16 window"])
        assertEquals(listOf("20, 10", "100  50  10", "103  50  10"), listOf("Worst pixel", "expected", "actual").map { rows[it] })
        assertTrue((rows["ꟻLIP mean"] ?: "0").toDouble() > 0, "$process")
        val map = ImageIO.read(folder.resolve("map.png").toFile())
        assertEquals(WIDTH to HEIGHT, map.width to map.height)

        fun brightness(x: Int, y: Int) =
            (map.getRGB(x, y) and 0xFF) + (map.getRGB(x, y) shr 8 and 0xFF) + (map.getRGB(x, y) shr 16 and 0xFF)
        assertTrue(brightness(28, 18) > brightness(2, 2))
    }

    @Test
    fun `without a locale it writes UTF-8, and says what reads such names`() {
        val classPath = System.getProperty("java.class.path")
        assumeTrue(classPath.all { it.code < 128 }, "without a locale Java loads no class from a folder with an umlaut")
        val none = listOf("LANG", "LC_ALL", "LC_CTYPE").associateWith { null }
        val table = CgaProcess.cga("diff", "a.png", "b.png", directory = folder, env = none)
        assertEnd(table, 1)
        assertEquals("red 3/255 · green 0 · blue 0", rows(table.out)["Largest difference"])
        val name = CgaProcess.cga("diff", "a.png", "Übung.png", directory = folder, env = none)
        assertEquals(2, name.exitCode, "$name")
        assertTrue("LC_ALL=C.UTF-8" in name.err || "Übung.png" in name.err, "$name")
    }

    @Test
    fun `float pictures are compared in their own unit`() {
        for ((name, red) in listOf("a.exr" to 0.5f, "b.exr" to 2.5f)) {
            ExrFile.write(FloatImage(1, 1, floatArrayOf(red, 0f, 0f, 1f)), folder.resolve(name))
        }
        val process = diff("a.exr", "b.exr")
        assertEnd(process, 1)
        assertEquals("red 2 · green 0 · blue 0 · alpha 0", rows(process.out)["Largest difference"])
        assertEquals("2.5  0  0  1", rows(process.out)["actual"])
    }

    @Test
    fun `a tolerance allows, warns or fails`() {
        for ((warn, fail, code) in listOf(Triple(3, 4, 0), Triple(2, 4, 0), Triple(1, 2, 1))) {
            val bounds = """"warn": "$warn/255", "fail": "$fail/255""""
            val rule = """{ "metric": "max", $bounds, "reason": "a test", "machine": "any" }"""
            folder.resolve("tolerance.json").writeText("""{ "byte": $rule }""")
            val process = diff("a.png", "b.png", "--tolerance", "tolerance.json")
            assertEquals(code, process.exitCode, "$process")
            assertEquals(warn < 3, process.err.isNotBlank(), "$process")
            assertEquals(warn < 3 && fail > 3, process.err.startsWith("warning: "), "$process")
        }
    }

    @Test
    fun `what cannot be compared ends with 2 and the reason in one line`() {
        folder.resolve("half.png").writeBytes(folder.resolve("a.png").readBytes().copyOf(90))
        ExrFile.write(FloatImage(1, 1, floatArrayOf(Float.NaN, 0f, 0f, 1f)), folder.resolve("nan.exr"))
        assertReason(diff("a.png", "turned.png"), "differ in size", "40x30", "30x40")
        assertReason(diff("a.png", "half.png"), "half.png", "cut off after 90 bytes")
        assertReason(diff("nan.exr", "a.png"), "nan.exr", "NaN in red at x = 0, y = 0")
        assertReason(diff("a.png", "missing.png"), "missing.png", "does not exist")
        assertReason(diff("a.png", "b.png", "--tolerance", "missing.json"), "missing.json", "does not exist")
    }

    @Test
    fun `a map never takes a picture's place`() {
        val before = folder.resolve("a.png").readBytes()
        val process = diff("a.png", "b.png", "--map", "./a.png")
        assertEquals(2, process.exitCode, "$process")
        assertTrue("--map ./a.png" in process.err, "$process")
        assertArrayEquals(before, folder.resolve("a.png").readBytes())
        assertReason(diff("a.png", "turned.png", "--map", "map.png"), "differ in size")
        assertFalse(folder.resolve("map.png").exists())
    }

    private fun diff(vararg args: String) = CgaProcess.cga("diff", *args, directory = folder)

    private fun assertEnd(process: CgaProcess, exitCode: Int) {
        assertEquals(exitCode, process.exitCode, "$process")
        assertEquals("", process.err, "$process")
    }

    private fun assertReason(process: CgaProcess, vararg parts: String) {
        assertEquals(2, process.exitCode, "$process")
        assertEquals("", process.out, "$process")
        assertEquals(1, process.err.trim().lines().size, "$process")
        for (part in listOf("cga: ", *parts)) assertTrue(part in process.err) { "\"$part\" is missing: $process" }
    }

    /** The table's second cells by their first. */
    private fun rows(table: String): Map<String, String> =
        table.lines().map { line -> line.split("│").map { it.trim() } }.filter { it.size == 4 }.associate { it[1] to it[2] }

    /** One colour, with a square of 16×16 pixels that is redder by [change]. */
    private fun picture(width: Int, height: Int, change: Int = 0): ImageData {
        val rgba = ByteArray(4 * width * height) { byteArrayOf(100, 50, 10, -1)[it % 4] }
        for (y in 10 until 26) for (x in 20 until minOf(36, width)) rgba[4 * (y * width + x)] = (100 + change).toByte()
        return ImageData(width, height, rgba)
    }

    private companion object {
        const val WIDTH = 40
        const val HEIGHT = 30
    }
}
