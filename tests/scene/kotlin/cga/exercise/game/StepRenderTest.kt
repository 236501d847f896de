package cga.exercise.game

import cga.framework.ColorFormat
import cga.framework.Frame
import cga.framework.FrameCone
import cga.framework.FrameDraw
import cga.framework.FrameLight
import cga.framework.FrameTexture
import cga.framework.RenderTarget
import cga.framework.SpecularModel
import cga.framework.image.FloatImage
import cga.testing.Offscreen
import org.joml.Matrix4d
import org.joml.Vector2d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import org.junit.jupiter.api.extension.ExtendWith
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.pow
import kotlin.math.sin

private const val WIDTH = 320
private const val HEIGHT = 180

/** A time at which the motorcycle has a saturated colour. */
private const val T = 5.5

/**
 * Every step draws what it adds. The ground is where this is looked at: what a pixel of it sees is known in closed form, and with it each
 * light's distance and angle.
 */
@ExtendWith(Offscreen::class)
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class StepRenderTest {
    private val scenes = HashMap<Double, ScriptedScene>()
    private val pictures = HashMap<Triple<Step, Double, Double>, Picture>()

    @Test
    fun `on the ground every step is emission and what the lights of its frame give`() {
        for (step in Step.entries) {
            val picture = picture(step)
            for (pixel in picture.ground.filter { it.distance < 15 && it.x % 2 == 0 }) {
                val emission = picture(Step.EMISSION)[pixel]
                for (c in 0..2) {
                    val tint = picture.frame.draws.first().tint[c]
                    val added = (picture[pixel, c] - emission[c] * tint).toDouble()
                    val (least, most) = picture.lightRange(pixel, c)
                    // Sums of a dozen floats of at most 4 err by less than 10⁻⁵.
                    assertTrue(added >= least - 1e-5 && added <= most + 1e-5) {
                        "${step.sheet}, channel $c of $pixel: $added is not in $least..$most"
                    }
                }
            }
        }
    }

    @Test
    fun `4_1 shows the emissive grid and between its lines nothing`() {
        val picture = picture(Step.EMISSION)
        val texels = picture.frame.draws.first().material.emissive
        // The near ground, so that a pixel is less than a tenth of a cell and only the first mip levels are sampled.
        val near = picture.ground.filter { it.distance < 3.5 }
        val middles = near.filter { it.inCell.x in 0.4..0.6 && it.inCell.y in 0.4..0.6 }
        val crossings = near.filter { abs(it.inCell.x - 0.5) > 0.49 && abs(it.inCell.y - 0.5) > 0.49 }
        assertTrue(middles.size > 50 && crossings.isNotEmpty(), "${middles.size} pixels between lines, ${crossings.size} on crossings")
        // A pixel's texels lie at most 0.2 cells from its middle; 8-bit filtering adds up to 1/255.
        val brightest = texels.max(0.2..0.8) + 1f / 255
        for (pixel in middles) assertTrue(picture[pixel].max() <= brightest, "$pixel: ${picture[pixel].toList()} above $brightest")
        for (pixel in crossings) assertTrue(picture[pixel].min() > 0.7f, "a crossing of lines at $pixel: ${picture[pixel].toList()}")
    }

    @Test
    fun `4_2 adds light beneath the motorcycle and takes none away`() {
        val before = picture(Step.EMISSION)
        val after = picture(Step.POINT_LIGHT)
        assertNowhereDarker(before, after)
        val light = after.frame.lights.single { it.cone == null }

        fun added(distances: ClosedRange<Double>) =
            after.ground.filter { it.world.distance(foot(light)) in distances }.map { after[it, 1] - before[it, 1] }.average()
        // The light is 1.28 above the ground: cos α is above 0.54 within 2 units of its foot and below 0.16 beyond 8.
        assertTrue(added(0.0..2.0) > 2 * added(8.0..12.0), "beneath ${added(0.0..2.0)}, far ${added(8.0..12.0)}")
        assertTrue(added(0.0..2.0) > 0.1)
    }

    @Test
    fun `4_3 brightens the ground within the headlight's cone and not outside`() {
        val before = picture(Step.POINT_LIGHT)
        val after = picture(Step.SPOT_LIGHT)
        assertNowhereDarker(before, after)
        val spot = after.frame.lights.single { it.cone != null }
        val (inside, rest) = after.ground.partition { angle(spot, it) < cone(spot).innerAngle }
        val outside = rest.filter { angle(spot, it) > cone(spot).outerAngle + SNAPPING_ANGLE }
        assertTrue(inside.size > 50 && outside.size > 5000, "${inside.size} pixels inside, ${outside.size} outside")
        assertTrue(inside.all { it.world.z < -2 }, "the cone is not ahead of the motorcycle")
        for (pixel in inside) {
            // M_d is at least 0.3, the headlight's red more than 1: cos α of it is what arrives.
            val cosAlpha = spot.position.y() / spot.position.distance(pixel.world)
            assertTrue(after[pixel, 0] > before[pixel, 0] + 0.3 * cosAlpha, "inside at $pixel")
        }
        for (pixel in outside) assertArrayEquals(before[pixel], after[pixel], "outside at $pixel")
    }

    @Test
    fun `4_3_4 darkens with distance, by F`() {
        val emission = picture(Step.EMISSION)
        val before = picture(Step.POINT_LIGHT)
        val after = picture(Step.ATTENUATION)
        val light = after.frame.lights.single { it.cone == null }
        val spot = after.frame.lights.single { it.cone != null }
        val outside = after.ground.filter { angle(spot, it) > cone(spot).outerAngle + SNAPPING_ANGLE && it.distance < 15 }
        var nearer = Double.MAX_VALUE
        for (pixels in outside.sortedBy { light.distance(it) }.chunked(outside.size / 20)) {
            val factors = pixels.map { (after[it, 0] - emission[it, 0]).toDouble() / (before[it, 0] - emission[it, 0]) }
            for ((pixel, factor) in pixels.zip(factors)) {
                // Differences of floats up to 1 err by 2⁻²³; what they are of is above 0.01 within 15 units.
                val (least, most) = pixel.range { light.factor(it) }
                assertTrue(factor in least - 1e-4..most + 1e-4, "F at $pixel: $factor, not $least..$most")
            }
            assertTrue(factors.average() < nearer, "not darker at ${light.distance(pixels.first())}")
            nearer = factors.average()
        }
    }

    @Test
    fun `4_4 has a ground that is green alone where no light reaches`() {
        // At time 0 the motorcycle and its light are black.
        val picture = picture(Step.COLOR, t = 0.0)
        val spot = picture.frame.lights.single { it.cone != null }
        val dark = picture.ground.filter { angle(spot, it) > cone(spot).outerAngle + SNAPPING_ANGLE }
        assertTrue(dark.size > 5000)
        for (pixel in dark) {
            val green = picture(Step.EMISSION)[pixel, 1]
            assertArrayEquals(floatArrayOf(0f, green, 0f), picture[pixel], "$pixel")
        }
    }

    @Test
    fun `4_4 colours the motorcycle and its light by time`() {
        val emission = picture(Step.EMISSION)
        val white = picture(Step.ATTENUATION)
        val colored = picture(Step.COLOR)
        val color = listOf(abs(sin(T)), abs(sin(T / 2)), abs(sin(T / 3)))
        val spot = white.frame.lights.single { it.cone != null }
        val lit = white.ground.filter { angle(spot, it) > cone(spot).outerAngle + SNAPPING_ANGLE && white[it, 0] - emission[it, 0] > 0.05f }
        assertTrue(lit.size > 500, "${lit.size} pixels of the pool")
        for (pixel in lit) {
            for (c in 0..2) {
                val light = (colored[pixel, c] - if (c == 1) emission[pixel, 1] else 0f) / (white[pixel, c] - emission[pixel, c])
                // Differences of floats up to 1 err by 2⁻²³, here of what is above 0.05.
                assertEquals(color[c], light.toDouble(), 1e-5, "light, channel $c of $pixel")
            }
        }
        // What emits in 4.1 and is black at time 0 is the motorcycle, out of its own headlight: all its light has the colour of time.
        val black = picture(Step.COLOR, t = 0.0)
        val glowing = white.motorcycle.filter { (x, y) -> emission[x, y, 1] > 0.2f && (0..2).all { black[x, y, it] == 0f } }
        assertTrue(glowing.size > 50, "${glowing.size} glowing pixels")
        for ((x, y) in glowing) {
            // A sum of two products of floats each, above 0.2.
            for (c in 0..2) assertEquals(color[c], colored[x, y, c] / white[x, y, c].toDouble(), 1e-5, "motorcycle, channel $c of ($x, $y)")
        }
    }

    @Test
    fun `4_5 turns with the mouse about the motorcycle, earlier steps do not`() {
        for (step in Step.entries) {
            val still = picture(step)
            val turned = picture(step, mouse = 400.0)
            if (step < Step.ORBIT) {
                assertArrayEquals(still.image.rgba, turned.image.rgba, "${step.sheet} turned")
            } else {
                val changed = still.ground.count { still[it, 1] != turned[it, 1] }
                assertTrue(changed > still.ground.size / 2, "${step.sheet}: only $changed of ${still.ground.size} pixels changed")
                val middle = Vector3d()
                // A motorcycle that left the focus would leave the middle column; the camera's matrix is made of floats.
                assertEquals(WIDTH / 2.0, turned.pixel(middle).x, 1e-3)
                assertEquals(still.pixel(middle).y, turned.pixel(middle).y, 1e-3)
            }
        }
        assertArrayEquals(picture(Step.COLOR).image.rgba, picture(Step.ORBIT).image.rgba, "4.5 without a mouse is 4.4")
    }

    @Test
    fun `4_6 has pools of the lights' colours in the corners`() {
        val corners = mutableSetOf<Pair<Int, Int>>()
        // Half a turn shows the two corners behind the camera.
        for (mouse in listOf(0.0, PI / 0.002)) {
            val before = picture(Step.ORBIT, mouse = mouse)
            val after = picture(Step.MORE_LIGHTS, mouse = mouse)
            assertNowhereDarker(before, after)
            for (light in after.frame.lights.filter { abs(it.position.x()) > 10 }) {
                val at = after.pixel(foot(light))
                if (at.x !in 0.0..WIDTH.toDouble() || after.depth(foot(light)) < 0) continue
                corners += (light.position.x() > 0) to (light.position.z() > 0) map { if (it) 1 else -1 }
                val added = Vector3d { c -> (after[at.x.toInt(), at.y.toInt(), c] - before[at.x.toInt(), at.y.toInt(), c]).toDouble() }
                val color = Vector3d(light.color)
                // The texture is grey, so the pool has its light's colour. The next corner light is 32 away, where F is 1/119, against
                // F = 1/1.7 at 1.2: what it adds is a 70th at most, and far less where the ground does not mirror it into the eye.
                assertTrue(added.length() > 0.3, "no pool at ${light.position}: $added")
                assertTrue(added.angle(color) < 0.02, "pool at ${light.position}: $added is not the colour $color")
            }
        }
        assertEquals(setOf(-1 to -1, 1 to -1, -1 to 1, 1 to 1), corners)
    }

    @Test
    fun `4_7 differs in the highlights alone, which are Blinn's`() {
        val before = picture(Step.MORE_LIGHTS)
        val after = picture(Step.BLINN_PHONG)
        var highlights = 0
        for (pixel in after.ground.filter { it.distance < 15 && it.x % 2 == 0 }) {
            for (c in 0..2) {
                val changed = (after[pixel, c] - before[pixel, c]).toDouble()
                val (least, most) = pixel.range { at -> after.highlights(at, c) - before.highlights(at, c) }
                val products = listOf(
                    least * after.gloss.start,
                    least * after.gloss.endInclusive,
                    most * after.gloss.start,
                    most * after.gloss.endInclusive,
                )
                // Rounding as in the test of all steps.
                assertTrue(changed in products.min() - 1e-5..products.max() + 1e-5, "channel $c of $pixel: $changed is not in $products")
                if (abs(changed) > 0.05) highlights++
            }
        }
        assertTrue(highlights > 100, "only $highlights changed visibly")
    }

    private fun scene(mouse: Double): ScriptedScene =
        scenes.getOrPut(mouse) { ScriptedScene(WIDTH, HEIGHT, Step.FINAL).apply { moveMouseTo(mouse) } }

    private fun picture(
        step: Step,
        t: Double = T,
        mouse: Double = 0.0,
    ): Picture =
        pictures.getOrPut(Triple(step, t, mouse)) {
            val scripted = scene(mouse)
            scripted.scene.step = step
            scripted.draw(ColorFormat.RGBA32F, t).use { Picture(scripted.scene.frame(), it.readFloats()) }
        }

    private fun assertNowhereDarker(
        before: Picture,
        after: Picture,
    ) {
        val darker = before.image.rgba.indices.firstOrNull { after.image.rgba[it] < before.image.rgba[it] }
        assertEquals(null, darker, "light was taken away")
    }

    private infix fun <A, B> Pair<A, A>.map(change: (A) -> B): Pair<B, B> = change(first) to change(second)
}

/** Draws the picture of time [t] into a new target. */
internal fun ScriptedScene.draw(
    format: ColorFormat,
    t: Double,
    samples: Int = 0,
): RenderTarget {
    advanceTo(t)
    return RenderTarget(framebufferWidth, framebufferHeight, samples, format).also { scene.render() }
}

/** A pixel that shows the ground; [inCell] is where in its cell of the grid, 0 to 1. [displaced] are points that it may show instead. */
private class GroundPixel(
    val x: Int,
    val y: Int,
    val world: Vector3d,
    val distance: Double,
    val displaced: List<Vector3d>,
) {
    val inCell = Vector2d((world.x / CELL).mod(1.0), (world.z / CELL).mod(1.0))

    /** The least and the largest value that [function] has where this pixel may look. */
    fun range(function: (Vector3d) -> Double): Pair<Double, Double> = (displaced + world).map(function).let { it.min() to it.max() }

    override fun toString() = "pixel ($x, $y) at $world"

    private companion object {
        /** The ground is 44.8 wide and has 64 cells; a line runs through the origin. */
        const val CELL = 0.7
    }
}

/** What was drawn, with what of. */
private class Picture(
    val frame: Frame,
    val image: FloatImage,
) {
    private val toWorld = frame.view.invert(Matrix4d())
    private val eye = toWorld.getTranslation(Vector3d())

    private val dull by lazy { frame.draws.first().material.diffuse.range() }

    /** The range of the ground's specular colours. */
    val gloss by lazy { frame.draws.first().material.specular.range() }

    /** Every pixel of the rectangle about the motorcycle, and a rim that antialiasing and snapping may touch. */
    val motorcycle: List<Pair<Int, Int>> = box(frame.draws.drop(1))

    /** The pixels that show the ground. */
    val ground: List<GroundPixel> =
        motorcycle.toSet().let { hidden ->
            (0 until HEIGHT).flatMap { y -> (0 until WIDTH).filter { x -> x to y !in hidden }.mapNotNull { x -> groundPixel(x, y) } }
        }

    operator fun get(
        x: Int,
        y: Int,
        c: Int,
    ): Float = image.rgba[4 * (y * WIDTH + x) + c]

    operator fun get(
        pixel: GroundPixel,
        c: Int,
    ): Float = this[pixel.x, pixel.y, c]

    operator fun get(pixel: GroundPixel): FloatArray = FloatArray(3) { this[pixel, it] }

    /** Where [world] is in the picture, in pixels from its top left corner. */
    fun pixel(world: Vector3d): Vector2d {
        val seen = frame.view.transformPosition(world, Vector3d())
        val x = seen.x / -seen.z * frame.projection.m00()
        val y = seen.y / -seen.z * frame.projection.m11()
        return Vector2d((x + 1) / 2 * WIDTH, (1 - y) / 2 * HEIGHT)
    }

    /** How far [world] is ahead of the eye. */
    fun depth(world: Vector3d): Double = -frame.view.transformPosition(world, Vector3d()).z

    /** The least and the most that the lights can add to channel [c] of [pixel], whatever the textures hold there. */
    fun lightRange(
        pixel: GroundPixel,
        c: Int,
    ): Pair<Double, Double> {
        val least = pixel.range { at -> diffuse(at, c) * dull.start + highlights(at, c) * gloss.start }.first
        val most = pixel.range { at -> diffuse(at, c) * dull.endInclusive + highlights(at, c) * gloss.endInclusive }.second
        return least to most
    }

    /** Σ I·F·max(cos α, 0)·L at a point of the ground. */
    private fun diffuse(
        at: Vector3d,
        c: Int,
    ): Double = sum(at, c) { toLight -> max(toLight.y, 0.0) }

    /** Σ I·F·max(cos β, 0)^k·L at a point of the ground. */
    fun highlights(
        at: Vector3d,
        c: Int,
    ): Double =
        sum(at, c) { toLight ->
            val toCamera = Vector3d(eye).sub(at).normalize()
            val cosine =
                when (frame.specularModel) {
                    SpecularModel.PHONG -> Vector3d(-toLight.x, toLight.y, -toLight.z).dot(toCamera)
                    SpecularModel.BLINN_PHONG -> Vector3d(toLight).add(toCamera).normalize().y
                }
            max(cosine, 0.0).pow(frame.draws.first().material.shininess.toDouble())
        }

    private fun sum(
        at: Vector3d,
        c: Int,
        reflectance: (toLight: Vector3d) -> Double,
    ): Double {
        fun term(light: FrameLight) = light.factor(at) * reflectance(light.position.sub(at, Vector3d()).normalize()) * light.color[c]
        return frame.lights.sumOf { it.intensity(at) * term(it) }
    }

    private fun groundPixel(
        x: Int,
        y: Int,
    ): GroundPixel? {
        val world = groundAt(x + 0.5, y + 0.5) ?: return null
        val displaced =
            listOf(-SNAPPING, SNAPPING).flatMap { dx -> listOf(-SNAPPING, SNAPPING).map { dy -> groundAt(x + 0.5 + dx, y + 0.5 + dy) } }
        return GroundPixel(x, y, world, world.distance(eye), displaced.map { it ?: return null })
    }

    private fun groundAt(
        x: Double,
        y: Double,
    ): Vector3d? {
        val ray = Vector3d((2 * x / WIDTH - 1) / frame.projection.m00(), (1 - 2 * y / HEIGHT) / frame.projection.m11(), -1.0)
        toWorld.transformDirection(ray)
        if (ray.y >= 0) return null
        val hit = ray.mul(-eye.y / ray.y).add(eye)
        return hit.takeIf { max(abs(it.x), abs(it.z)) < GROUND_HALF }
    }

    private fun box(draws: List<FrameDraw>): List<Pair<Int, Int>> {
        val seen =
            draws.flatMap { draw ->
                draw.vertices.indices.step(8).map { i ->
                    pixel(draw.model.transformPosition(Vector3d { draw.vertices[i + it].toDouble() }))
                }
            }
        val columns = (seen.minOf { it.x }.toInt() - 2)..(seen.maxOf { it.x }.toInt() + 2)
        val rows = (seen.minOf { it.y }.toInt() - 2)..(seen.maxOf { it.y }.toInt() + 2)
        return rows.flatMap { y -> columns.map { x -> x to y } }
    }

    private companion object {
        /** The ground's edge is at 22.4; a little less, to stay clear of it. */
        const val GROUND_HALF = 22.3

        /**
         * OpenGL snaps vertices to a grid of 2⁻⁴ pixels at least (Mesa: 2⁻⁸), so that a pixel's middle shows a point up to half as far
         * away; both coordinates of three vertices, so with a margin of 2.
         */
        const val SNAPPING = 1.0 / 256
    }
}

/** A pixel displaced by [Picture]'s snapping sees a light at an angle that differs by less than this (radians). */
private const val SNAPPING_ANGLE = 0.01

private fun Vector3d(component: (Int) -> Double) = Vector3d(component(0), component(1), component(2))

private fun foot(light: FrameLight) = Vector3d(light.position.x(), 0.0, light.position.z())

private fun FrameLight.distance(pixel: GroundPixel): Double = position.distance(pixel.world)

/** F. */
private fun FrameLight.factor(at: Vector3d): Double {
    val d = position.distance(at)
    return 1 / (attenuation.x() + attenuation.y() * d + attenuation.z() * d * d)
}

private fun cosine(
    spot: FrameLight,
    at: Vector3d,
): Double = Vector3d(at).sub(spot.position).normalize().dot(cone(spot).direction)

private fun cone(spot: FrameLight): FrameCone = checkNotNull(spot.cone)

private fun angle(
    spot: FrameLight,
    pixel: GroundPixel,
): Double = acos(cosine(spot, pixel.world))

/** I. */
private fun FrameLight.intensity(at: Vector3d): Double {
    val cone = cone ?: return 1.0
    val outer = cos(cone.outerAngle.toDouble())
    return ((cosine(this, at) - outer) / (cos(cone.innerAngle.toDouble()) - outer)).coerceIn(0.0, 1.0)
}

/** What sampling can give: from the least to the largest texel of all levels, and 1/255 for filtering in 8 bits. All textures are grey. */
private fun FrameTexture.range(): ClosedRange<Double> {
    val texels = image.levels.flatMap { level -> level.rgba.indices.filter { it % 4 != 3 }.map { level.rgba[it].toInt() and 0xFF } }
    return (texels.min() - 1) / 255.0..(texels.max() + 1) / 255.0
}

/** The brightest texel of the first four levels among those with both coordinates in [part]. */
private fun FrameTexture.max(part: ClosedRange<Double>): Float =
    image.levels.take(4).maxOf { level ->
        val inside = (0 until level.width).filter { (it + 0.5) / level.width in part }
        inside.maxOf { y -> inside.maxOf { x -> level.rgba[4 * (y * level.width + x)].toInt() and 0xFF } }
    } / 255f
