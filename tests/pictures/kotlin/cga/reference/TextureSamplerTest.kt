package cga.reference

import cga.framework.FrameTexture
import cga.framework.image.ImageData
import cga.framework.image.TextureImage
import cga.testing.assertNear
import cga.testing.assertRefused
import org.joml.Vector2d
import org.joml.Vector3d
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.*
import kotlin.math.pow

/** Textures against values worked out by hand. Texels are gray and written row by row from the lowest, as t counts. */
class TextureSamplerTest {
    /** Texel centres at s = 1/8, 3/8, 5/8, 7/8. */
    private val row = listOf(listOf(0, 100, 200, 40))

    @Test
    fun `nearest takes the texel that the point is in`() {
        for ((s, expected) in mapOf(0.0 to 0, 0.2499 to 0, 0.25 to 100, 0.6 to 200, 0.9999 to 40)) {
            assertSample(expected, row, s, GL_REPEAT, GL_NEAREST)
        }
    }

    @Test
    fun `each wrap mode goes on beyond the edges in its way`() {
        val places = listOf(-1.1, -0.6, -0.1, 1.1, 1.4, 2.3)
        val expected =
            mapOf(
                GL_REPEAT to listOf(40, 100, 40, 0, 100, 100),
                GL_CLAMP_TO_EDGE to listOf(0, 0, 0, 40, 40, 40),
                GL_CLAMP_TO_BORDER to listOf(0, 0, 0, 0, 0, 0),
                GL_MIRRORED_REPEAT to listOf(40, 200, 0, 40, 200, 100),
            )
        for ((wrap, texels) in expected) for ((s, texel) in places.zip(texels)) assertSample(texel, row, s, wrap, GL_NEAREST)
    }

    @Test
    fun `linear mixes the four texels around`() {
        assertSample(100, row, 3 / 8.0, GL_REPEAT, GL_LINEAR)
        assertSample(125, row, 7 / 16.0, GL_REPEAT, GL_LINEAR)
        // Between the last texel and the first; beyond the centre of the last one; between it and the border.
        assertSample(20, row, 1.0, GL_REPEAT, GL_LINEAR)
        assertSample(40, row, 0.95, GL_CLAMP_TO_EDGE, GL_LINEAR)
        assertSample(20, row, 1.0, GL_CLAMP_TO_BORDER, GL_LINEAR)
        assertSample(40, row, 1.0, GL_MIRRORED_REPEAT, GL_LINEAR)
        val square = listOf(listOf(0, 40), listOf(80, 200))
        assertNear(
            gray((0 * 3 + 40) * 3 / 16.0 + (80 * 3 + 200) / 16.0),
            sample(square, Vector2d(0.375, 0.375), GL_REPEAT, GL_LINEAR),
            1e-15,
        )
    }

    @Test
    fun `t counts from the lowest row upwards`() {
        val column = listOf(listOf(10), listOf(20), listOf(30), listOf(40))
        for ((t, expected) in listOf(0.1 to 10, 0.4 to 20, 0.6 to 30, 0.9 to 40)) {
            assertNear(gray(expected), sample(column, Vector2d(0.5, t), GL_REPEAT, GL_NEAREST), 1e-15)
        }
    }

    @Test
    fun `lambda is the logarithm of the longer of the two steps in texels`() {
        val sampler = TextureSampler(texture(List(8) { List(16) { 0 } }, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR))

        fun lambda(dsdx: Double, dtdx: Double, dsdy: Double, dtdy: Double) = sampler.levelOfDetail(
            Vector2d(dsdx, dtdx),
            Vector2d(dsdy, dtdy),
        )
        assertNear(0.0, lambda(1 / 16.0, 0.0, 0.0, 1 / 8.0), 1e-15)
        assertNear(1.0, lambda(1 / 16.0, 0.0, 0.0, 2 / 8.0), 1e-15)
        assertNear(-1.0, lambda(0.5 / 16, 0.0, 0.0, 0.25 / 8), 1e-15)
        // A step of 3 texels in s and 4 in t is 5 long.
        assertNear(2.321928094887362, lambda(3 / 16.0, -4 / 8.0, 1 / 16.0, 1 / 8.0), 1e-15)
    }

    @Test
    fun `each minification filter takes its levels`() {
        // Level i of the 8×8 texture is 10·(i + 1) all over.
        val levels = listOf(10.0, 20.0, 30.0, 40.0)
        val lambdas = listOf(-1.0, 0.0, 0.1, 0.49, 0.51, 1.0, 1.25, 1.49, 1.51, 2.75, 3.0, 9.0)
        val expected =
            mapOf(
                GL_NEAREST to lambdas.map { 10.0 },
                GL_LINEAR to lambdas.map { 10.0 },
                GL_LINEAR_MIPMAP_NEAREST to listOf(0, 0, 0, 0, 1, 1, 1, 1, 2, 3, 3, 3).map { levels[it] },
                GL_NEAREST_MIPMAP_NEAREST to listOf(0, 0, 0, 0, 1, 1, 1, 1, 2, 3, 3, 3).map { levels[it] },
                GL_LINEAR_MIPMAP_LINEAR to listOf(10.0, 10.0, 11.0, 14.9, 15.1, 20.0, 22.5, 24.9, 25.1, 37.5, 40.0, 40.0),
                // Magnification is linear here, so minification starts at c = 0.5 only.
                GL_NEAREST_MIPMAP_LINEAR to listOf(10.0, 10.0, 10.0, 10.0, 15.1, 20.0, 22.5, 24.9, 25.1, 37.5, 40.0, 40.0),
            )
        for ((filter, grays) in expected) {
            val sampler = TextureSampler(FrameTexture(levelled(), GL_REPEAT, GL_REPEAT, filter, GL_LINEAR))
            for ((lambda, gray) in lambdas.zip(grays)) {
                val step = Vector2d(2.0.pow(lambda) / 8, 0.0)
                assertNear(
                    gray(gray),
                    sampler.sample(Vector2d(0.3, 0.7), step, Vector2d(), Vector3d()),
                    1e-14,
                    "0x%X at $lambda".format(filter),
                )
            }
        }
    }

    @Test
    fun `what OpenGL does not know is refused`() {
        assertRefused("0x1234") { TextureSampler(texture(row, 0x1234, GL_LINEAR, GL_LINEAR)) }
        assertRefused("0x1234") { TextureSampler(texture(row, GL_REPEAT, 0x1234, GL_LINEAR)) }
        assertRefused("LINEAR_MIPMAP_LINEAR") { TextureSampler(texture(row, GL_REPEAT, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR)) }
    }

    private fun assertSample(expected: Int, texels: List<List<Int>>, s: Double, wrap: Int, filter: Int) =
        assertNear(gray(expected), sample(texels, Vector2d(s, 0.5), wrap, filter), 1e-14, "s = $s, wrap mode 0x%X".format(wrap))

    private fun sample(texels: List<List<Int>>, at: Vector2d, wrap: Int, filter: Int) =
        TextureSampler(texture(texels, wrap, filter, filter)).sample(at, Vector2d(), Vector2d(), Vector3d())

    private fun gray(value: Number) = Vector3d(value.toDouble() / 255)

    private fun texture(texels: List<List<Int>>, wrap: Int, minFilter: Int, magFilter: Int) =
        FrameTexture(TextureImage(image(texels), false), wrap, wrap, minFilter, magFilter)

    private fun image(texels: List<List<Int>>): ImageData {
        val bytes = texels.reversed().flatten().flatMap { listOf(it.toByte(), it.toByte(), it.toByte(), -1) }
        return ImageData(texels[0].size, texels.size, bytes.toByteArray())
    }

    /** 8×8 with all mip levels, which are then painted over. */
    private fun levelled(): TextureImage {
        val image = TextureImage(image(List(8) { List(8) { 0 } }), true)
        image.levels.forEachIndexed { i, level -> level.rgba.fill((10 * (i + 1)).toByte()) }
        return image
    }
}
