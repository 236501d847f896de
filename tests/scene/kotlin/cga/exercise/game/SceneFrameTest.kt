package cga.exercise.game

import cga.exercise.components.shader.ShaderSource
import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.FrameLight
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.assertNear
import org.joml.Matrix4d
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sin

/** What the finished scene holds. */
class SceneFrameTest {
    private val scripted = ScriptedScene(1280, 720, drive = DriveScript.parse("W 1.3, WA 2.1"))
    private val start = scripted.scene.frame()

    @Test
    fun `the ground is green, matt as the course's and tiled 64 times`() {
        val ground = start.ground()
        assertEquals(Vector3f(0f, 1f, 0f), ground.tint)
        assertEquals(60f, ground.material.shininess)
        assertEquals(Vector2f(64f), ground.material.tcMultiplier)
        assertEquals(Matrix4d(), ground.model)
        for (draw in start.motorcycle()) assertEquals(Vector2f(1f), draw.material.tcMultiplier)
    }

    @Test
    fun `the motorcycle and its light have the colours of time`() {
        for (t in listOf(0.0, 0.5, 1.0, PI, 3.7, 100.0, 12_345.678, 1e7, 1e7 + 0.25)) {
            scripted.scene.update(0.0, t)
            val frame = scripted.scene.frame()
            val expected = Vector3d(abs(sin(t)), abs(sin(t / 2)), abs(sin(t / 3)))
            for (draw in frame.motorcycle()) assertNear(expected, draw.tint, FLOAT_ROUNDING, "at $t s")
            assertEquals(frame.motorcycle().first().tint, frame.ofMotorcycle().color)
            assertEquals(Vector3f(0f, 1f, 0f), frame.ground().tint)
        }
    }

    @Test
    fun `at ten million seconds no digit of the colour is lost`() {
        scripted.scene.update(0.0, 1e7)
        // The sines of 1e7, 1e7/2 and 1e7/3 to ten digits, from a calculator of 30.
        val expected = Vector3d(SIN_1E7, SIN_1E7_2, SIN_1E7_3)
        // The argument 1e7/3 is off by half an ulp of a double, 2.3e-10; then it rounds to a float.
        assertNear(expected, scripted.scene.frame().motorcycle().first().tint, FLOAT_ROUNDING + 1e-9)
    }

    @Test
    fun `there is a light in each corner, of its own colour, just above the ground`() {
        val corners = start.corners()
        assertEquals(setOf(-1 to -1, -1 to 1, 1 to -1, 1 to 1), corners.map { sign(it.position.x()) to sign(it.position.z()) }.toSet())
        assertEquals(4, corners.size)
        assertEquals(4, corners.map { it.color }.toSet().size)
        for (light in corners) {
            // The outer third of a ground of ±22.4.
            assertTrue(abs(light.position.x()) in 15.0..22.4 && abs(light.position.z()) in 15.0..22.4) { "${light.position}" }
            assertTrue(light.position.y() in 0.5..1.5)
        }
        assertNotEquals(start.ofMotorcycle().color, corners.first().color)
    }

    @Test
    fun `the shaders have room for the lights`() {
        for (shader in listOf("shaders/scene.vert", "shaders/scene.frag")) {
            val source = ShaderSource.read(shader).text
            assertTrue("const int LIGHTS = 10;" in source) { shader }
        }
        assertTrue(start.lights.size <= 10)
    }

    @Test
    fun `the motorcycle's light is above it, to shine on the ground`() {
        val light = start.ofMotorcycle()
        assertTrue(light.position.y() > 0.5 && abs(light.position.x()) < 0.1 && abs(light.position.z()) < 1) { "${light.position}" }
    }

    @Test
    fun `the spotlight is at the motorcycle's front and shines ahead and down`() {
        val spot = start.headlight()
        val front = start.motorcycle().minOf { lowestZ(it) } * 0.8
        assertTrue(spot.position.z() < front / 2 && spot.position.y() > 0) { "${spot.position}, the front is at $front" }
        val cone = checkNotNull(spot.cone)
        assertTrue(cone.direction.y() < 0 && cone.direction.z() < -0.9) { "${cone.direction}" }
        // Where the axis meets the ground: ahead of the front wheel, and on the ground plane.
        val reach = spot.position.y() / -cone.direction.y()
        assertTrue(spot.position.z() + reach * cone.direction.z() in -22.4..front)
        assertTrue(cone.innerAngle > 0 && cone.innerAngle < cone.outerAngle)
    }

    @Test
    fun `camera and lights ride along, the corner lights stay`() {
        scripted.advanceTo(3.4)
        val driven = scripted.scene.frame()
        assertNotEquals(start.motorcycle().first().model, driven.motorcycle().first().model)
        // A turn, scale and place rounded to floats; nothing is farther from the motorcycle than 4.
        val tolerance = 16 * 4 * FLOAT_ROUNDING
        assertNear(start.fromMotorcycle(start.ofMotorcycle()), driven.fromMotorcycle(driven.ofMotorcycle()), tolerance)
        assertNear(
            start.fromMotorcycle(start.headlight()),
            driven.fromMotorcycle(driven.headlight()),
            tolerance,
        )
        assertNear(
            start.view.mul(start.motorcycle().first().model, Matrix4d()),
            driven.view.mul(driven.motorcycle().first().model, Matrix4d()),
            tolerance,
        )
        assertEquals(start.corners().map { it.position }, driven.corners().map { it.position })
    }

    @Test
    fun `vectors to the lights are as long in view space as in the world`() {
        scripted.advanceTo(3.4)
        scripted.moveMouseTo(777.0)
        val frame = scripted.scene.frame()
        for (light in frame.lights) {
            for (point in listOf(Vector3d(), Vector3d(22.4, 0.0, -22.4), Vector3d(-1.5, 0.7, 3.0))) {
                val toLight = frame.view.transformPosition(Vector3d(light.position)).sub(frame.view.transformPosition(Vector3d(point)))
                // A rigid matrix in double: a dozen roundings of numbers up to 64.
                assertNear(light.position.distance(point), toLight.length(), 12 * 64 * DOUBLE_ROUNDING)
            }
        }
    }

    @Test
    fun `the camera has the constants of the course`() {
        // Vertical field of view 90°, 16:9.
        assertNear(9.0 / 16, start.projection.m00(), 4 * FLOAT_ROUNDING)
        assertNear(1.0, start.projection.m11(), 4 * FLOAT_ROUNDING)
        // It looks down 35°: so steep is its view of the world's y axis.
        assertNear(Vector3d(0.0, 0.8191520443, 0.5735764364), start.view.transformDirection(Vector3d(0.0, 1.0, 0.0)), 4 * FLOAT_ROUNDING)
    }

    @Test
    fun `a frame does not change with its scene`() {
        val view = Matrix4d(start.view)
        val tint = Vector3f(start.motorcycle().first().tint)
        val position = Vector3d(start.ofMotorcycle().position)
        scripted.advanceTo(3.0)
        scripted.moveMouseTo(500.0)
        scripted.scene.frame()
        assertEquals(view, start.view)
        assertEquals(tint, start.motorcycle().first().tint)
        assertEquals(tint, start.ofMotorcycle().color)
        assertEquals(position, start.ofMotorcycle().position)
    }

    private fun Frame.ground(): FrameDraw = draws.first()

    private fun Frame.motorcycle(): List<FrameDraw> = draws.drop(1)

    private fun Frame.ofMotorcycle(): FrameLight = lights.first()

    private fun Frame.headlight(): FrameLight = lights.single { it.cone != null }

    private fun Frame.corners(): List<FrameLight> = lights.drop(1) - headlight()

    private fun Frame.fromMotorcycle(light: FrameLight): Vector3d =
        motorcycle().first().model.invert(Matrix4d()).transformPosition(Vector3d(light.position))

    private fun lowestZ(draw: FrameDraw): Float = (2 until draw.vertices.size step 8).minOf { draw.vertices[it] }

    private fun sign(number: Double) = if (number < 0) -1 else 1

    private companion object {
        const val SIN_1E7 = 0.4205477932
        const val SIN_1E7_2 = 0.9765424687
        const val SIN_1E7_3 = 0.1441787548
    }
}
