package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.testing.FLOAT_ROUNDING
import cga.testing.QUARTER
import cga.testing.RecordingProgram
import cga.testing.assertNear
import cga.testing.assertRefused
import cga.testing.turn
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector2d
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.lang.reflect.Modifier
import java.math.BigDecimal
import java.math.MathContext
import kotlin.random.Random

class SpotLightTest {
    private val program = RecordingProgram()
    private val white = Vector3f(1f)

    @Test
    fun `it sends what a point light sends, the direction and the cone`() {
        SpotLight(Vector3f(1f, 2f, 3f), Vector3f(4f, 5f, 6f), 0f, QUARTER).bind(program, "light[1]")
        val expected =
            mapOf(
                "light[1].position" to Vector3f(1f, 2f, 3f),
                "light[1].color" to Vector3f(4f, 5f, 6f),
                "light[1].attenuation" to Vector3f(0.5f, 0.05f, 0.01f),
                "light[1].direction" to Vector3f(0f, 0f, -1f),
                "light[1].cone" to Vector2f(0f, 1f),
            )
        assertEquals(expected.keys, program.sent.keys)
        for ((name, value) in expected) assertNear(value, program.sent.getValue(name), 0.0, name)
    }

    @Test
    fun `the cone is sent as versines, right to an ulp`() {
        val degrees = listOf(0.0, 1e-30, 1e-6, 0.001, 0.01, 0.1, 1.0, 16.0, 28.0, 45.0, 60.0, 89.999, 90.0)
        for (angle in degrees.map { Math.toRadians(it).toFloat() }) {
            SpotLight(Vector3f(), white, angle, angle).bind(program, "light")
            val sent = program.sent.getValue("light.cone") as Vector2f
            val error = (BigDecimal(sent.x.toDouble()) - versine(angle)).abs()
            assertTrue(error <= BigDecimal(Math.ulp(sent.x).toDouble())) { "1 − cos $angle is ${versine(angle)}, sent is ${sent.x}" }
            assertEquals(sent.x, sent.y)
        }
    }

    @Test
    fun `the inner cone comes first`() {
        SpotLight(Vector3f(), white, 0.2f, 0.4f).bind(program, "light")
        // 1 − cos 0.2 and 1 − cos 0.4 from a table, to ten digits; the angles are floats.
        assertNear(Vector2d(0.0199334222, 0.0789390060), program.sent.getValue("light.cone"), 4 * 0.08 * FLOAT_ROUNDING)
    }

    @Test
    fun `turned down it shines down, turned left it shines left`() {
        assertDirection(Vector3d(0.0, -1.0, 0.0), SpotLight(Vector3f(), white, 0.1f, 0.2f).apply { rotateLocal(-QUARTER, 0f, 0f) })
        assertDirection(Vector3d(-1.0, 0.0, 0.0), SpotLight(Vector3f(), white, 0.1f, 0.2f).apply { rotateLocal(0f, QUARTER, 0f) })
    }

    @Test
    fun `the direction has unit length however its parents are turned and scaled`() {
        val random = Random(1)

        fun angle() = random.nextFloat() * 6 - 3
        repeat(1_000) {
            val parent = Transformable().apply {
                scaleLocal(Vector3f(random.nextFloat() * 1e4f + 1e-4f))
                rotateLocal(angle(), angle(), angle())
            }
            val light = SpotLight(Vector3f(5f, 6f, 7f), white, 0.1f, 0.2f)
            light.parent = parent
            light.rotateLocal(angle(), angle(), angle())
            light.bind(program, "light")
            // Normalised in double; each coordinate is then rounded to a float, and so the length at most.
            assertNear(1.0, Vector3d(program.vector("light.direction")).length(), 1.01 * FLOAT_ROUNDING)
        }
    }

    @Test
    fun `the direction turns with the motorcycle and into view space`() {
        val motorcycle = Transformable(Matrix4f().translation(5f, 0f, 5f).rotateY(0.7f).scale(0.8f))
        val light = SpotLight(Vector3f(0f, 0.7f, -1.7f), white, 0.1f, 0.2f).apply {
            rotateLocal(-0.15f, 0f, 0f)
            parent = motorcycle
        }
        val view = Matrix4d(turn(0.4, -2.0, 0.0)).translate(1.0, 2.0, 3.0)
        light.bind(program, "light", view)
        val world = turn(0f, 0.7f, 0f).mul(turn(-0.15f, 0f, 0f)).transform(Vector3d(0.0, 0.0, -1.0))
        val expected = turn(0.4, -2.0, 0.0).transform(Vector3d(world))
        // Sine and cosine of both float turns, the scale's product with them, and the result: eight roundings and more never add up.
        assertNear(world, light.getDirection(Vector3d()), 8 * FLOAT_ROUNDING)
        assertNear(expected, program.vector("light.direction"), 8 * FLOAT_ROUNDING)
    }

    @Test
    fun `the form of the sheet's interface sends the same`() {
        val light = SpotLight(Vector3f(1f, 2f, 3f), white, 0.1f, 0.2f).apply { rotateLocal(0.3f, 0.2f, 0.1f) }
        val view = Matrix4f().rotateY(0.5f).translate(3f, 2f, 1f)
        (light as ISpotLight).bind(program, "a", view)
        light.bind(program, "b", Matrix4d(view))
        for (member in listOf("position", "color", "attenuation", "direction", "cone")) {
            assertEquals(program.sent.getValue("b.$member"), program.sent.getValue("a.$member"))
        }
    }

    @Test
    fun `as plain data it keeps its angles and its direction`() {
        val light = SpotLight(Vector3f(1f, 2f, 3f), white, 0.1f, 0.2f)
        val data = light.toFrameLight()
        light.rotateLocal(1f, 1f, 1f)
        val cone = checkNotNull(data.cone)
        assertEquals(listOf(0.1f, 0.2f), listOf(cone.innerAngle, cone.outerAngle))
        assertNear(Vector3d(0.0, 0.0, -1.0), cone.direction, 0.0)
        assertEquals(Vector3d(1.0, 2.0, 3.0), data.position)
    }

    @Test
    fun `the angles are its own business`() {
        val angles = SpotLight::class.java.declaredFields.filter { "Angle" in it.name }
        assertEquals(2, angles.size)
        assertTrue(angles.all { Modifier.isPrivate(it.modifiers) })
        assertTrue(SpotLight::class.java.methods.none { "Angle" in it.name })
    }

    @Test
    fun `angles that make no cones are refused`() {
        val beyond = Math.nextUp(QUARTER)
        val bad =
            listOf(0.3f to 0.2f, -0.1f to 0.2f, 0.1f to beyond, beyond to beyond, -0.2f to -0.1f, 0.1f to 3f) +
                listOf(Float.NaN to 0.2f, 0.1f to Float.NaN, Float.NEGATIVE_INFINITY to 0.2f, 0.1f to Float.POSITIVE_INFINITY)
        for ((inner, outer) in bad) assertRefused(inner, outer) { SpotLight(Vector3f(), white, inner, outer) }
        for ((inner, outer) in listOf(0f to 0f, 0f to QUARTER, QUARTER to QUARTER, 0.2f to 0.2f)) {
            SpotLight(Vector3f(), white, inner, outer)
        }
    }

    @Test
    fun `it refuses what a point light refuses`() {
        val bad = Vector3f(Float.NaN, 1f, -1f)
        val zero = Vector3f()
        assertRefused(bad) { SpotLight(bad, white, 0.1f, 0.2f) }
        assertRefused(bad) { SpotLight(zero, bad, 0.1f, 0.2f) }
        assertRefused(bad) { SpotLight(zero, white, 0.1f, 0.2f, bad) }
        assertRefused(zero) { SpotLight(zero, white, 0.1f, 0.2f, zero) }
        val light = SpotLight(zero, white, 0.1f, 0.2f)
        assertRefused(bad) { light.lightColor = bad }
        assertRefused(zero) { light.attenuation = zero }
    }

    private fun assertDirection(expected: Vector3d, light: SpotLight) {
        light.bind(program, "light")
        // The float quarter's cosine.
        assertNear(expected, program.vector("light.direction"), FLOAT_ROUNDING)
    }

    /** 1 − cos a = a²/2! − a⁴/4! + a⁶/6! − …, to 40 digits. */
    private fun versine(angle: Float): BigDecimal {
        val digits = MathContext(40)
        val square = BigDecimal(angle.toDouble()).pow(2)
        var term = square.divide(BigDecimal(2), digits)
        var sum = term
        for (n in 3..41 step 2) {
            term = term.multiply(square).divide(BigDecimal(-n * (n + 1)), digits)
            sum = sum.add(term, digits)
        }
        return sum
    }
}
