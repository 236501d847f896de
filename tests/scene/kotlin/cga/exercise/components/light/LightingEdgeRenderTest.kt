package cga.exercise.components.light

import cga.exercise.components.geometry.Material
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.ColorFormat
import cga.framework.FrameLight
import cga.framework.GLError
import cga.framework.RenderTarget
import cga.testing.Offscreen
import cga.testing.Slow
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.pow
import kotlin.math.sin
import kotlin.random.Random

/**
 * The shaders against the lighting model in double precision, at the edges of its domain and in between: one surface point a picture,
 * drawn as one vertex into one pixel, so that what is shaded is exactly what is given. World space is view space here.
 */
@ExtendWith(Offscreen::class)
@Slow
class LightingEdgeRenderTest {
    private val surface = Surface()
    private val bothModels = listOf(surface.copy(blinnPhong = false), surface.copy(blinnPhong = true))

    @Test
    fun `random surfaces and lights agree with the formula in double precision`() {
        val random = Random(4)
        repeat(300) {
            val points = List(random.nextInt(0, 9)) { point(random.vector(3.0), random.color(), random.attenuation()) }
            val lights = points + List(random.nextInt(0, 3)) { spot(random) }
            val k = listOf(0f, 1f, 8f, 60f, 200f).random(random)
            val surface =
                Surface(
                    position = random.vector(2.0).sub(0f, 0f, 4f),
                    normal = random.vector(1.0).normalize(random.nextDouble(0.1, 10.0).toFloat()),
                    emissive = random.color(),
                    diffuse = random.color(),
                    specular = random.color(),
                    shininess = k,
                    tint = random.color(),
                    ambient = random.color(),
                    blinnPhong = random.nextBoolean(),
                )
            assertShaded(surface, lights, "seed 4, round $it: $surface")
        }
    }

    @Test
    fun `a spotlight is full inside, linear in the cosine between, and dark outside`() {
        val inner = radians(20.0)
        val outer = radians(40.0)
        for (degrees in listOf(0.0, 10.0, 19.9, 20.1, 25.0, 30.0, 35.0, 39.9, 40.1, 60.0, 90.0, 120.0, 180.0)) {
            val light = SpotLight(atAngle(degrees), WHITE, inner, outer, CONSTANT)
            val lit = shade(facing(light), lights = listOf(light))[0].toDouble()
            val expected = (
                (
                    cos(
                        Math.toRadians(degrees),
                    ) - cos(outer.toDouble())
                ) / (cos(inner.toDouble()) - cos(outer.toDouble()))
            ).coerceIn(0.0, 1.0)
            assertEquals(expected, lit, coneBound(outer.toDouble()) + DIFFUSE_BOUND, "$degrees°")
        }
    }

    // The textbook's cosines would be wrong by 38/255 at 0.1° and by everything at 0.01°.
    @Test
    fun `narrow cones err by no more than the rounding of two unit vectors over the angle`() {
        for (degrees in listOf(30.0, 1.0, 0.1, 0.01, 0.001)) {
            val outer = radians(degrees)
            for (share in listOf(0.0, 0.3, 0.5, 0.6, 0.75, 0.9, 1.0, 1.2)) {
                val light = SpotLight(Vector3f(), WHITE, outer / 2, outer, CONSTANT).apply { rotateLocal(0.7f, -1.1f, 0.3f) }
                val axis = light.getDirection(Vector3d())
                val position = axis.rotateAxis(share * outer, 0.6, 0.0, 0.8, Vector3d()).mul(3.0)
                val point = Surface(position = Vector3f(position), normal = Vector3f(position).negate(), specular = BLACK, emissive = BLACK)
                val expected = reference(point, listOf(light))[0]
                val lit = shade(point, lights = listOf(light))[0].toDouble()
                assertEquals(expected, lit, coneBound(outer.toDouble()) + DIFFUSE_BOUND, "cone of $degrees°, at $share of it")
            }
        }
    }

    @Test
    fun `eight point lights and two spotlights shine at once, and none beyond the count`() {
        val random = Random(8)
        val points = List(8) { point(random.vector(3.0), random.color()) }
        val spots = List(2) { spot(random) }
        for (surface in bothModels) {
            assertShaded(surface, points + spots, "all ten")
            val some = shade(surface, points.take(3) + spots.take(1))
            shade(surface, points + spots)
            assertArrayEquals(some, shade(surface, points.take(3) + spots.take(1)), "what an earlier picture left in the uniforms counts")
            assertArrayEquals(shade(surface), reference(surface).map { it.toFloat() }.toFloatArray(), ULPS_OF_TWO_TERMS, "no light")
        }
    }

    @Test
    fun `distance 0 is no contribution of that light`() {
        for (surface in bothModels.flatMap { listOf(it, it.copy(shininess = 0f)) }) {
            val other = point(Vector3f(1f, 1f, 0f), Vector3f(0.3f))
            val alone = shade(surface, listOf(other))
            for (k in listOf(Vector3f(1f, 0.5f, 0.1f), Vector3f(0f, 0f, 1f))) {
                assertArrayEquals(alone, shade(surface, listOf(point(surface.position, WHITE, k), other)), "point light, K = $k")
                assertArrayEquals(
                    alone,
                    shade(surface, listOf(other, SpotLight(surface.position, WHITE, 1f, 1.5f, k))),
                    "spotlight, K = $k",
                )
            }
        }
    }

    @Test
    fun `half vector 0 has no highlight`() {
        for (k in listOf(0f, 1f, 60f)) {
            val behind = point(surface.position.mul(2f, Vector3f()), WHITE, CONSTANT)
            for (normal in listOf(Vector3f(1f, 0f, 0f), surface.position, Vector3f(surface.position).negate())) {
                val shiny = surface.copy(blinnPhong = true, normal = normal, shininess = k, diffuse = BLACK)
                assertArrayEquals(shade(shiny), shade(shiny, listOf(behind)), "k = $k, normal $normal")
            }
        }
    }

    @Test
    fun `a cosine of 0 to the power of 0 is no highlight`() {
        val light = point(Vector3f(0f, 4f, -4f), WHITE, CONSTANT)
        // The light from above; mirrored it goes up again: at right angles to the eye. The half vector lies in the plane of the surface.
        val below = surface.copy(position = Vector3f(0f, 0f, -4f), diffuse = BLACK, shininess = 0f)
        val right = below.copy(blinnPhong = false, normal = Vector3f(0f, 1f, 0f))
        val rightHalf = right.copy(blinnPhong = true, normal = Vector3f(1f, 0f, 0f))
        // And away from the eye: a negative cosine.
        val away = right.copy(normal = Vector3f(0f, 1f, -1f))
        val awayHalf = rightHalf.copy(normal = Vector3f(0f, -1f, -1f))
        for (dark in listOf(right, rightHalf, away, awayHalf)) assertArrayEquals(shade(dark), shade(dark, listOf(light)), "$dark")
        for (bright in listOf(right.copy(normal = Vector3f(0f, 1f, 1f)), rightHalf.copy(normal = Vector3f(0f, 1f, 1f)))) {
            assertShaded(bright, listOf(light), "any other cosine to the power of 0 is 1")
            assertTrue(shade(bright, listOf(light))[0] > shade(bright)[0] + 0.5f, "a highlight was expected of $bright")
        }
    }

    @Test
    fun `equal cone angles are a step at the edge`() {
        val edge = radians(30.0)
        for ((degrees, expected) in mapOf(0.0 to 1f, 29.99 to 1f, 30.01 to 0f, 90.0 to 0f)) {
            val light = SpotLight(atAngle(degrees), WHITE, edge, edge, CONSTANT)
            assertEquals(expected, shade(facing(light), lights = listOf(light))[0], DIFFUSE_BOUND.toFloat(), "$degrees°")
        }
        for ((degrees, expected) in mapOf(0.0 to 1f, 0.01 to 0f)) {
            val light = SpotLight(atAngle(degrees), WHITE, 0f, 0f, CONSTANT)
            assertEquals(expected, shade(facing(light), lights = listOf(light))[0], DIFFUSE_BOUND.toFloat(), "angle 0, at $degrees°")
        }
    }

    @Test
    fun `a light whose squared distance overflows does not shine, and one just nearer does`() {
        for (surface in bothModels.map { it.copy(position = Vector3f(0f, 0f, -4f)) }) {
            val dark = shade(surface)
            for (distance in listOf(1.85e19f, 1e20f, 1e30f, 3e38f)) {
                for (k in listOf(CONSTANT, Vector3f(1f, 0.5f, 0.1f), Vector3f(0f, 0f, 1f))) {
                    val far = Vector3f(0f, distance, 0f)
                    assertArrayEquals(dark, shade(surface, listOf(point(far, WHITE, k))), "point light at $distance, K = $k")
                    assertArrayEquals(
                        dark,
                        shade(surface, lights = listOf(SpotLight(far, WHITE, 1f, 1.5f, k))),
                        "spotlight at $distance, K = $k",
                    )
                }
            }
            assertTrue(shade(surface, listOf(point(Vector3f(0f, 1.8e19f, 0f), WHITE, CONSTANT)))[0] > dark[0] + 0.1f)
        }
    }

    @Test
    fun `a distance beyond all floats is no light, not NaN`() {
        for (surface in bothModels.map { it.copy(position = Vector3f(0f, -3e38f, 0f)) }) {
            assertArrayEquals(shade(surface), shade(surface, listOf(point(Vector3f(0f, 3e38f, 0f), WHITE))), "$surface")
        }
    }

    @Test
    fun `normal 0 has only emission and ambient`() {
        // All around, for without a normal no side is the wrong one; that behind the surface is where a mirrored vector meets the eye.
        val around = listOf(Vector3f(0f, 4f, -4f), Vector3f(0f, -4f, -4f), Vector3f(0f, 0f, -8f), Vector3f(), Vector3f(4f, 0f, -4f))
        for (surface in bothModels.map { it.copy(normal = Vector3f(), ambient = Vector3f(0.25f)) }) {
            val dark = shade(surface)
            assertArrayEquals(dark, reference(surface).map { it.toFloat() }.toFloatArray(), ULPS_OF_TWO_TERMS)
            for (place in around) {
                for (k in listOf(0f, 60f)) {
                    val lit = shade(surface.copy(shininess = k), listOf(point(place, WHITE, CONSTANT)))
                    assertArrayEquals(dark, lit, "light at $place, k = $k, Blinn-Phong ${surface.blinnPhong}")
                }
            }
        }
    }

    @Test
    fun `gamma raises the finished colour to its inverse, and none changes no bit`() {
        val light = listOf(point(Vector3f(1f, 2f, -2f), Vector3f(2f)))
        val linear = shade(surface, light)
        assertArrayEquals(linear, shade(surface.copy(inverseGamma = 1f), light))
        for (gamma in listOf(2.2, 0.5)) {
            val encoded = shade(surface.copy(inverseGamma = (1 / gamma).toFloat()), light)
            for (c in 0..2) {
                val expected = linear[c].toDouble().pow(1 / gamma)
                // pow(x, y) is exp2(y·log2 x): 2⁻²¹ in the logarithm for x in [0.5, 2] and 3 ulp else, (3 + 2|y·log2 x|) ulp in exp2
                // (GLSL 4.60, 4.7.1). For these colours, 0.01 to 4, and y ≤ 2 that is less than 2⁻¹⁸ of the result.
                assertEquals(expected, encoded[c].toDouble(), expected / (1 shl 18), "gamma $gamma, channel $c of ${linear.toList()}")
            }
        }
    }

    @Test
    fun `gamma of black and of negative light is black`() {
        val black = surface.copy(emissive = BLACK, inverseGamma = (1 / 2.2).toFloat())
        assertArrayEquals(floatArrayOf(0f, 0f, 0f), shade(black))
        assertArrayEquals(floatArrayOf(0f, 0f, 0f), shade(black, listOf(point(Vector3f(1f, 2f, -2f), Vector3f(-1f)))))
    }

    /** The point of a surface that is drawn, the eye being at the origin, and the rest of what decides its colour. */
    private data class Surface(
        val position: Vector3f = Vector3f(0.5f, -1f, -4f),
        val normal: Vector3f = Vector3f(0f, 2f, 1f),
        val emissive: Vector3f = Vector3f(0.2f, 0f, 0.4f),
        val diffuse: Vector3f = Vector3f(0.6f, 0.8f, 1f),
        val specular: Vector3f = Vector3f(1f, 0.8f, 0.2f),
        val shininess: Float = 60f,
        val tint: Vector3f = Vector3f(1f),
        val ambient: Vector3f = Vector3f(),
        val blinnPhong: Boolean = true,
        val inverseGamma: Float = 1f,
    )

    private fun point(
        position: Vector3f,
        color: Vector3fc,
        k: Vector3f = Vector3f(1f, 0.5f, 0.1f),
    ) = PointLight(position, color, k)

    /** A spotlight near the surface, pointing roughly at it. */
    private fun spot(random: Random): SpotLight {
        val outer = random.nextDouble(0.1, PI / 2).toFloat()
        val light =
            SpotLight(random.vector(2.0).add(0f, 0f, 2f), random.color(), outer * random.nextFloat() * 0.9f, outer, random.attenuation())
        return light.apply { rotateLocal(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, 0f) }
    }

    /** Where a light that looks along −z must stand for (0, 0, −4) to lie at this angle from its axis, 4 away. */
    private fun atAngle(degrees: Double): Vector3f {
        val angle = Math.toRadians(degrees)
        return Vector3f((4 * sin(angle)).toFloat(), 0f, (4 * cos(angle) - 4).toFloat())
    }

    /** A white, dull surface that turns its face to the light, so that its colour is the light's intensity. */
    private fun facing(light: PointLight): Surface {
        val position = Vector3f(0f, 0f, -4f)
        val normal = light.getWorldPosition().sub(position)
        return Surface(position, normal, emissive = BLACK, diffuse = Vector3f(1f), specular = BLACK)
    }

    private fun shade(
        surface: Surface,
        lights: List<PointLight> = emptyList(),
    ): FloatArray {
        val program = Gpu.program(lights.size)
        program.use()
        program.setUniform("modelView", Matrix4f().translation(surface.position), false)
        program.setUniform("normalMatrix", Matrix3f(), false)
        // Whatever the vertex, the middle of the pixel.
        program.setUniform("projection", Matrix4f().zero().m33(1f), false)
        program.setUniform("emissiveTint", surface.tint)
        program.setUniform("ambient", surface.ambient)
        program.setUniform("blinnPhong", surface.blinnPhong)
        program.setUniform("inverseGamma", surface.inverseGamma)
        lights.forEachIndexed { i, light -> light.bind(program, "light[$i]", IDENTITY) }
        return Gpu.draw(surface, program)
    }

    private object Gpu {
        private val programs = HashMap<Int, ShaderProgram>()

        /** The scene's shaders for so many lights. */
        fun program(lights: Int): ShaderProgram =
            programs.getOrPut(lights) { ShaderProgram("shaders/scene.vert", "shaders/scene.frag", mapOf("LIGHTS" to lights)) }

        fun draw(
            surface: Surface,
            program: ShaderProgram,
        ): FloatArray {
            val material = Material(plain(surface.diffuse), plain(surface.emissive), plain(surface.specular), surface.shininess)
            val vertices = glGenVertexArrays()
            RenderTarget(1, 1, 0, ColorFormat.RGBA32F).use { target ->
                glClearColor(9f, 9f, 9f, 9f)
                glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
                material.bind(program)
                glBindVertexArray(vertices)
                // No arrays: the one vertex has the current attributes.
                glVertexAttrib3f(0, 0f, 0f, 0f)
                glVertexAttrib2f(1, 0f, 0f)
                glVertexAttrib3f(2, surface.normal.x, surface.normal.y, surface.normal.z)
                glDrawArrays(GL_POINTS, 0, 1)
                GLError.check("drawing $surface")
                glDeleteVertexArrays(vertices)
                material.cleanup()
                return target.readFloats().rgba.copyOf(3)
            }
        }

        private fun plain(color: Vector3f) = Texture2D(color)
    }

    private fun assertShaded(
        surface: Surface,
        lights: List<PointLight>,
        what: String,
    ) {
        val expected = reference(surface, lights)
        val actual = shade(surface, lights)
        val bound = bound(surface, lights)
        for (c in 0..2) assertEquals(expected[c], actual[c].toDouble(), bound, "channel $c; $what")
    }

    private fun reference(
        surface: Surface,
        lights: List<PointLight> = emptyList(),
    ): DoubleArray {
        val color = DoubleArray(3) {
            surface.emissive[it].toDouble() * surface.tint[it] +
                surface.diffuse[it].toDouble() * surface.ambient[it]
        }
        for (light in lights) light.toFrameLight().let { add(surface, it, intensity(surface, it), color) }
        return color
    }

    /** Adds I·F·(M_d·max(cos α, 0) + M_s·max(cos β, 0)^k)·L to [color]. */
    private fun add(
        surface: Surface,
        light: FrameLight,
        intensity: Double,
        color: DoubleArray,
    ) {
        val n = Vector3d(surface.normal)
        if (n.length() == 0.0) return
        n.normalize()
        val toLight = light.position.sub(Vector3d(surface.position), Vector3d())
        val f = attenuation(light)(toLight.length())
        toLight.normalize()
        val toCamera = Vector3d(surface.position).negate().normalize()
        val cosBeta =
            if (surface.blinnPhong) {
                n.dot(toLight.add(toCamera, Vector3d()).normalize())
            } else {
                n.mul(2 * n.dot(toLight), Vector3d()).sub(toLight).dot(toCamera)
            }
        val highlight = if (cosBeta > 0) cosBeta.pow(surface.shininess.toDouble()) else 0.0
        for (c in 0..2) {
            val reflectance = surface.diffuse[c].toDouble() * max(n.dot(toLight), 0.0) + surface.specular[c].toDouble() * highlight
            color[c] += intensity * f * reflectance * light.color[c]
        }
    }

    private fun attenuation(light: FrameLight) = { d: Double ->
        1 / (light.attenuation.x() + light.attenuation.y() * d + light.attenuation.z() * d * d)
    }

    /** The sheet's formula with the prose's angles. */
    private fun intensity(
        surface: Surface,
        light: FrameLight,
    ): Double {
        val cone = light.cone ?: return 1.0
        val fromLight = Vector3d(surface.position).sub(light.position).normalize()
        val outer = cos(cone.outerAngle.toDouble())
        return ((fromLight.dot(cone.direction) - outer) / (cos(cone.innerAngle.toDouble()) - outer)).coerceIn(0.0, 1.0)
    }

    /**
     * How far the shader's floats may be from the formula, for the sum of all lights at their brightest.
     *
     * With u = 2⁻²⁴ and GLSL's own precisions (4.60, 4.7.1: inversesqrt 2 ulp, division 2.5 ulp, logarithm 2⁻²¹, exp2 (3 + 2|x|) ulp; an
     * ulp is 2u), to first order: a normalised vector errs by 7u (3u/2 from the squared length, 4u, a product), after the subtraction
     * light − position by another 2u·S, where S is the distances of both from the eye over their distance from each other. A cosine of
     * two of them errs by (17 + 2S)u; the mirrored vector by (61 + 4S)u and its cosine by (71 + 4S)u; the half vector of length h by
     * (15 + 2S)u·2/h + 7u and its cosine by that and 10u. p = c^k ≤ 1 errs by k times the cosine's error, by k·ln 2·8u from the logarithm
     * and by 9u from exp2. F errs by (10 + 4S)u of itself, and the products and sums that follow by 3u a light.
     */
    private fun bound(
        surface: Surface,
        lights: List<PointLight>,
    ): Double {
        fun term(light: FrameLight): Double {
            val toLight = light.position.sub(Vector3d(surface.position), Vector3d())
            val d = toLight.length()
            val s = (surface.position.length() + light.position.length()) / d
            val h = toLight.normalize().add(Vector3d(surface.position).negate().normalize()).length()
            val highlightCosine = if (surface.blinnPhong) (15 + 2 * s) * 2 / h + 17 else 71 + 4 * s
            val errors = (17 + 2 * s) + surface.shininess * (highlightCosine + 6) + 9 + 2 * (10 + 4 * s) + 6
            return attenuation(light)(d) * light.color.get(light.color.maxComponent()) * errors * U
        }

        fun coneTerm(light: FrameLight): Double {
            val cone = light.cone ?: return 0.0
            val brightest = light.color.get(light.color.maxComponent())
            val d = light.position.distance(Vector3d(surface.position))
            // Diffuse and specular together reflect at most twice the light.
            return 2 * attenuation(light)(d) * brightest * coneBound(cone.outerAngle.toDouble(), cone.innerAngle.toDouble())
        }
        return lights.map { it.toFrameLight() }.sumOf { term(it) + coneTerm(it) } + ULPS_OF_TWO_TERMS
    }

    /**
     * The error of I = (V_outer − c²/2) / (V_outer − V_inner), where c = |l − s| ≤ 2·sin(outer/2) matters.
     *
     * The precision of inversesqrt and of the squared length (11u/2) only changes how long l is, along l, and for a given direction
     * |l − s|² = |l|² + |s|² − 2·l·s is at its smallest near length 1: such errors count squared, (3u + 7u)²/2. What turns l and s is the
     * rounding of components: in light − position (both are exact here), in l and in s; each is a vector no longer than u. So c²/2 errs
     * by 3u·c, and by 3u of itself for its squares and sums; the versines by u of themselves.
     */
    private fun coneBound(
        outer: Double,
        inner: Double = outer / 2,
    ): Double {
        val largest = 2 * sin(outer / 2)
        val versine = largest * largest / 2
        val width = versine - 2 * sin(inner / 2) * sin(inner / 2)
        return (3 * U * largest + 5 * U * versine + 50 * U * U) / width + 5 * U
    }

    private fun Random.vector(size: Double) = Vector3f(coordinate(size), coordinate(size), coordinate(size))

    private fun Random.coordinate(size: Double) = nextDouble(-size, size).toFloat()

    private fun Random.color() = Vector3f(nextFloat(), nextFloat(), nextFloat())

    private fun Random.attenuation() = Vector3f(0.2f + nextFloat(), nextFloat(), nextFloat())

    private companion object {
        val IDENTITY = Matrix4d()
        val WHITE = Vector3f(1f)
        val BLACK: Vector3f get() = Vector3f()
        val CONSTANT = Vector3f(1f, 0f, 0f)

        /** Unit roundoff of a float. */
        const val U = 1.0 / (1 shl 24)

        /** A white dull surface facing one light of brightness 1: the cosine's 17u and F's 10u of [bound], with S ≤ 2. */
        const val DIFFUSE_BOUND = 40 * U

        /** Emission and ambient, both at most 1: two texels converted from 8 bits, two products, a sum. */
        const val ULPS_OF_TWO_TERMS = 8f * U.toFloat()

        fun radians(degrees: Double): Float = Math.toRadians(degrees).toFloat()
    }
}
