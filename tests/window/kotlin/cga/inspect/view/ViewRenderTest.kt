package cga.inspect.view

import cga.framework.SpecularModel
import cga.framework.image.FloatImage
import cga.inspect.Inspected
import cga.inspect.probe.Expected
import cga.reference.ReferenceRenderer
import cga.testing.FLOAT_ROUNDING
import cga.testing.Offscreen
import cga.testing.Slow
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import kotlin.math.abs

/** What the views show, on the real scene and against the reference. */
@ExtendWith(Offscreen::class)
@Slow
class ViewRenderTest {
    private val inspected = Inspected()
    private val scene = inspected.scene
    private val look = inspected.look

    @AfterEach
    fun cleanUp() = scene.cleanup()

    @Test
    fun `the four terms alone add up to everything`() {
        scene.ambient = Vector3f(0.2f, 0.3f, 0.1f)
        val full = inspected.draw()
        val terms = listOf(View.EMISSION, View.AMBIENT, View.DIFFUSE, View.SPECULAR).map(::draw)
        // Each of the 14 numbers that are added is rounded, in another order; the largest sum is 8.
        assertSame(full, sum(terms), 28 * 8 * FLOAT_ROUNDING)
        for (term in terms) assertTrue(term.rgba.withIndex().any { (i, x) -> i % 4 != 3 && x > 0.05f }) { "a term is black" }
    }

    @Test
    fun `the lights alone add up to all`() {
        val dark = draw(View.EMISSION)
        look.view = View.FULL
        val full = inspected.draw()
        val shares = (0 until 6).map { light ->
            look.solo(light)
            inspected.draw().also { look.solo(light) }.let { minus(it, dark) }
        }
        assertTrue(look.areAllOn)
        assertSame(full, sum(shares + dark), 2 * 28 * 8 * FLOAT_ROUNDING)
        for ((i, share) in shares.withIndex()) assertTrue(share.rgba.any { it > 0.01f }) { "light $i makes no difference" }
    }

    @Test
    fun `every view shows what the reference says, for every light and both specular models`() {
        for (model in SpecularModel.entries) {
            scene.specularModel = model
            val frame = scene.frame()
            val renderer = ReferenceRenderer(frame, Inspected.WIDTH, Inspected.HEIGHT)
            for ((x, y) in PIXELS) {
                val point = checkNotNull(renderer.probe(x, y)) { "nothing at $x, $y" }
                for (view in View.entries) {
                    for (light in if (view.isOfOneLight) 0 until 6 else 0..0) {
                        look.light = light
                        val drawn = pixel(draw(view), x, y)
                        val expected = Expected.color(point, frame, look)
                        val tolerance = if (view.factor == null) TEXTURED else FACTOR
                        val error = Vector3d(expected).sub(drawn).absolute().let { maxOf(it.x, it.y, it.z) }
                        assertTrue(error <= tolerance) { "$view of light $light with $model at $x, $y: $drawn, should be $expected" }
                    }
                }
            }
        }
    }

    @Test
    fun `the specular model of the look is the one that is drawn`() {
        scene.specularModel = SpecularModel.PHONG
        val phong = inspected.draw()
        look.specularModel = SpecularModel.BLINN_PHONG
        val looked = inspected.draw()
        look.specularModel = null
        scene.specularModel = SpecularModel.BLINN_PHONG
        assertEquals(inspected.draw().rgba.toList(), looked.rgba.toList())
        assertTrue(!phong.rgba.contentEquals(looked.rgba)) { "both models draw the same" }
    }

    private fun draw(view: View): FloatImage {
        look.view = view
        return inspected.draw()
    }

    private fun pixel(image: FloatImage, x: Int, y: Int) =
        (4 * (y * image.width + x)).let {
            Vector3d(
                image.rgba[it].toDouble(),
                image.rgba[it + 1].toDouble(),
                image.rgba[it + 2].toDouble(),
            )
        }

    private fun sum(images: List<FloatImage>) =
        FloatImage(
            images[0].width,
            images[0].height,
            FloatArray(images[0].rgba.size) { i -> images.sumOf { it.rgba[i].toDouble() }.toFloat() },
        )

    private fun minus(a: FloatImage, b: FloatImage) = FloatImage(a.width, a.height, FloatArray(a.rgba.size) { a.rgba[it] - b.rgba[it] })

    private fun assertSame(expected: FloatImage, actual: FloatImage, tolerance: Double) {
        for (i in expected.rgba.indices) {
            if (i % 4 == 3) continue
            val error = abs(expected.rgba[i] - actual.rgba[i])
            assertTrue(error <= tolerance) { "number $i is ${actual.rgba[i]}, should be ${expected.rgba[i]}: off by $error of $tolerance" }
        }
    }

    private companion object {
        /** On the ground: left, ahead in the headlight, right and near. */
        val PIXELS = listOf(40 to 60, 80 to 22, 130 to 75)

        /** Vertices are moved to a grid of 1/256 pixel, and no factor changes by more than a third from one of these pixels to the next. */
        const val FACTOR = 1.0 / 3 / 256

        /** llvmpipe filters textures in steps of 1/255, up to 0.75 of one, at a brightness of at most 4; and a mip level of its own rounding. */
        const val TEXTURED = 4 * 2.0 / 255
    }
}
