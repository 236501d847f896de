package cga.grading.worker

import cga.grading.capture.Capture
import cga.grading.capture.CapturedTexture
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.opengl.GL33C.GL_LINEAR
import org.lwjgl.opengl.GL33C.GL_REPEAT
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

class TextureFilesTest {
    @TempDir
    lateinit var folder: Path

    /** 2 × 3 texels, the first row at the top; [seed] makes images different. */
    private fun texel(
        seed: Int,
        x: Int,
        y: Int,
    ) = listOf(seed, 40 * x, 60 * y)

    private fun write(
        name: String,
        seed: Int,
    ) {
        val image = BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB)
        for (y in 0 until HEIGHT) {
            for (x in 0 until WIDTH) image.setRGB(x, y, texel(seed, x, y).fold(0) { all, part -> all shl 8 or part })
        }
        val file = folder.resolve(name)
        file.parent.createDirectories()
        ImageIO.write(image, "png", file.toFile())
    }

    private fun texture(
        seed: Int,
        isFlipped: Boolean,
        alpha: Int = 255,
    ): CapturedTexture {
        val rows = (0 until HEIGHT).let { if (isFlipped) it.reversed() else it.toList() }
        val bytes = rows.flatMap { y -> (0 until WIDTH).flatMap { x -> texel(seed, x, y) + alpha } }.map { it.toByte() }.toByteArray()
        return CapturedTexture(WIDTH, HEIGHT, listOf(bytes), GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR)
    }

    private fun files(vararg textures: CapturedTexture): Map<Int, String> =
        TextureFiles.of(Capture(1, 1, emptyList(), emptyList(), textures.toList(), emptyList(), emptyList()), folder)

    @Test
    fun `a texture has the name of the file with its texels, either way up and with any alpha`() {
        write("ground_diff.png", 1)
        write("deep/in/folders/Ground_Emit.png", 2)
        val names = files(texture(2, isFlipped = true), texture(1, isFlipped = false, alpha = 0), texture(3, isFlipped = false))
        assertEquals(mapOf(0 to "Ground_Emit.png", 1 to "ground_diff.png"), names)
    }

    @Test
    fun `what several files look like, or a file that names no use, tells nothing`() {
        write("one_diff.png", 1)
        write("one_spec.png", 1)
        write("picture.png", 2)
        folder.resolve("broken_diff.png").writeText("no picture")
        assertEquals(emptyMap<Int, String>(), files(texture(1, isFlipped = false), texture(2, isFlipped = false)))
    }

    private companion object {
        const val WIDTH = 2
        const val HEIGHT = 3
    }
}
