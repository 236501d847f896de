package cga.exercise.components.light

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Transformable
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.QUARTER
import cga.testing.RecordingProgram
import cga.testing.assertNear
import cga.testing.assertRefused
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.random.Random

class PointLightTest {
    private val program = RecordingProgram()
    private val white = Vector3f(1f)

    @Test
    fun `it sends position, colour and attenuation to the struct of the name`() {
        PointLight(Vector3f(1f, 2f, 3f), Vector3f(0.5f, 4f, 0f), Vector3f(1f, 0f, 0.5f)).bind(program, "light[3]")
        val expected =
            mapOf(
                "light[3].position" to Vector3f(1f, 2f, 3f),
                "light[3].color" to Vector3f(0.5f, 4f, 0f),
                "light[3].attenuation" to Vector3f(1f, 0f, 0.5f),
                "light[3].direction" to Vector3f(),
                "light[3].cone" to Vector2f(3f, 4f),
            )
        assertEquals(expected, program.sent)
    }

    @Test
    fun `it attenuates as Table 1 says unless told otherwise`() {
        PointLight(Vector3f(), white).bind(program, "light")
        assertEquals(Vector3f(1.0f, 0.5f, 0.1f), program.vector("light.attenuation"))
    }

    @Test
    fun `one light can go by several names in turn`() {
        val light = PointLight(Vector3f(1f, 2f, 3f), white)
        for (name in listOf("a", "b", "a")) light.bind(program, name)
        assertEquals(10, program.sent.size)
        assertEquals(program.vector("a.position"), program.vector("b.position"))
    }

    @Test
    fun `it is placed in the world, then moved as any object`() {
        val light = PointLight(Vector3f(1f, 2f, 3f), white)
        assertEquals(Vector3f(1f, 2f, 3f), light.getPosition())
        light.translateGlobal(Vector3f(0f, 1f, 0f))
        light.bind(program, "light")
        assertEquals(Vector3f(1f, 3f, 3f), program.vector("light.position"))
    }

    @Test
    fun `the two-argument form sends the world position of a child of the scaled motorcycle`() {
        light(motorcycle(10f, -3f), 0f, 1.6f, -1f).bind(program, "light")
        // By hand: the quarter turn takes (0, 1.28, −0.8) to (−0.8, 1.28, 0). 0.8, the turn and the sum are floats.
        assertNear(Vector3d(9.2, 1.28, -3.0), program.vector("light.position"), 4 * 10 * FLOAT_ROUNDING)
    }

    @Test
    fun `the three-argument form sends the position in view space`() {
        val light = PointLight(Vector3f(1f, 2f, 3f), white)
        light.bind(program, "before", Matrix4d().translation(0.0, 0.0, -5.0))
        assertEquals(Vector3f(1f, 2f, -2f), program.vector("before.position"))

        // A camera at (4, 0, 0) that is turned to look along −x sees −x as its −z, and −z as its +x.
        val view = TronCamera().apply { setLocalModelMatrix(Matrix4f().translation(4f, 0f, 0f).rotateY(QUARTER)) }.view()
        light.bind(program, "turned", view)
        assertNear(Vector3f(-3f, 2f, -3f), program.vector("turned.position"), 8 * FLOAT_ROUNDING)
    }

    @Test
    fun `the vector to the light in view space is as long as in the world though the motorcycle is scaled`() {
        assertDistancesKept(motorcycle(10f, -3f))
    }

    @Test
    fun `and it is a million units from the origin`() {
        assertDistancesKept(motorcycle(1e6f, -1e6f))
    }

    @Test
    fun `colour and attenuation can be set, and are copied`() {
        val color = Vector3f(1f, 2f, 3f)
        val k = Vector3f(0f, 0f, 1f)
        val light = PointLight(Vector3f(), white)
        light.lightColor = color
        light.attenuation = k
        color.set(9f)
        k.set(9f)
        assertEquals(Vector3f(1f, 2f, 3f), light.lightColor)
        assertEquals(Vector3f(0f, 0f, 1f), light.attenuation)
        light.bind(program, "light")
        assertEquals(Vector3f(1f, 2f, 3f), program.vector("light.color"))
        assertEquals(Vector3f(0f, 0f, 1f), program.vector("light.attenuation"))
    }

    @Test
    fun `as plain data it is a copy of what it was`() {
        val light = light(motorcycle(10f, -3f), 0f, 1.6f, -1f)
        val data = light.toFrameLight()
        light.lightColor = Vector3f(7f)
        light.attenuation = Vector3f(7f)
        light.translateGlobal(Vector3f(7f))
        assertNear(Vector3d(9.2, 1.28, -3.0), data.position, 4 * 10 * FLOAT_ROUNDING)
        assertEquals(white, data.color)
        assertEquals(Vector3f(1.0f, 0.5f, 0.1f), data.attenuation)
    }

    @Test
    fun `a position, colour or attenuation that is not finite is refused`() {
        for (number in listOf(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY)) {
            for (bad in listOf(Vector3f(number, 1f, 2f), Vector3f(1f, number, 2f), Vector3f(1f, 2f, number))) {
                assertRefused(bad) { PointLight(bad, white) }
                assertRefused(bad) { PointLight(Vector3f(), bad) }
                assertRefusedAttenuation(bad)
                assertUnchanged { assertRefused(bad) { it.lightColor = bad } }
                assertUnchanged { assertRefused(bad) { it.translateLocal(bad) } }
                assertUnchanged { assertRefused(bad) { it.translateGlobal(bad) } }
            }
        }
    }

    @Test
    fun `an attenuation with a negative number, or of zeros alone, is refused`() {
        for (bad in listOf(Vector3f(-1f, 0.5f, 0.1f), Vector3f(1f, -0.5f, 0.1f), Vector3f(1f, 0.5f, -0.1f), Vector3f(), Vector3f(-0f))) {
            assertRefusedAttenuation(bad)
        }
        for (good in listOf(Vector3f(1f, 0f, 0f), Vector3f(0f, 1f, 0f), Vector3f(0f, 0f, Float.MIN_VALUE))) {
            assertEquals(good, PointLight(Vector3f(), white, good).attenuation)
        }
    }

    private fun assertRefusedAttenuation(bad: Vector3fc) {
        assertRefused(bad) { PointLight(Vector3f(), white, bad) }
        assertUnchanged { assertRefused(bad) { it.attenuation = bad } }
    }

    private fun assertUnchanged(refusal: (PointLight) -> Unit) {
        val light = PointLight(Vector3f(1f, 2f, 3f), white)
        refusal(light)
        assertEquals(white, light.lightColor)
        assertEquals(Vector3f(1.0f, 0.5f, 0.1f), light.attenuation)
        assertEquals(Vector3f(1f, 2f, 3f), light.getWorldPosition())
    }

    /** Camera and light ride along with the [motorcycle]; points of the ground around it are lit. */
    private fun assertDistancesKept(motorcycle: Transformable) {
        val camera = TronCamera(parent = motorcycle).apply {
            rotateLocal(-0.61f, 0f, 0f)
            translateLocal(Vector3f(0f, 0f, 4f))
        }
        val light = light(motorcycle, 0f, 1.6f, -1f)
        light.bind(program, "light", camera.view())
        val world = light.getWorldPosition(Vector3d())
        val sent = Vector3d(program.vector("light.position"))

        val random = Random(1)
        repeat(100) {
            val point = Vector3d(world.x + random.nextDouble(-20.0, 20.0), 0.0, world.z + random.nextDouble(-20.0, 20.0))
            val toLight = camera.view().transformPosition(point, Vector3d()).sub(sent)
            // What is sent is rounded to floats; both distances come from positions in double, of which the largest rounds most.
            val tolerance = sent.length() * FLOAT_ROUNDING + 16 * world.length() * DOUBLE_ROUNDING
            assertNear(world.distance(point), toLight.length(), tolerance)
        }
    }

    private fun light(parent: Transformable, x: Float, y: Float, z: Float) =
        PointLight(Vector3f(x, y, z), white).also { it.parent = parent }

    private fun motorcycle(x: Float, z: Float) = Transformable(Matrix4f().translation(x, 0f, z).rotateY(QUARTER).scale(0.8f))

    private fun TronCamera.view(): Matrix4d = calculateViewMatrix(Matrix4d())
}
