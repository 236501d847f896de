package cga.exercise.game

import cga.exercise.components.geometry.Transformable
import cga.testing.RecordingProgram
import org.joml.Matrix4d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class SceneLightsTest {
    private val lights = SceneLights(Transformable())

    @Test
    fun `each step sends its lights, numbered from 0, and how many they are`() {
        for ((step, count) in Step.entries.zip(listOf(0, 1, 2, 2, 2, 2, 6, 6))) {
            lights.switchTo(step)
            val members = listOf("position", "color", "attenuation", "direction", "cone")
            assertEquals((0 until count).flatMap { i -> members.map { "light[$i].$it" } }.toSet(), sent().keys, "$step")
            assertEquals(mapOf("LIGHTS" to count), lights.count(step), "$step")
        }
    }

    @Test
    fun `back at an earlier step, lights do not attenuate again`() {
        lights.switchTo(Step.FINAL)
        lights.switchTo(Step.SPOT_LIGHT)
        assertEquals(Vector3f(1f, 0f, 0f), sent()["light[1].attenuation"])
        lights.switchTo(Step.ATTENUATION)
        assertEquals(Vector3f(0.5f, 0.05f, 0.01f), sent()["light[1].attenuation"])
    }

    @Test
    fun `the motorcycle's colour is its own light's alone`() {
        lights.switchTo(Step.FINAL)
        val before = sent()
        lights.setMotorcycleColor(Vector3f(0.1f, 0.2f, 0.3f))
        assertEquals(before + ("light[0].color" to Vector3f(0.1f, 0.2f, 0.3f)), sent())
    }

    private fun sent(): Map<String, Any> = RecordingProgram().also { lights.bind(it, Matrix4d()) }.sent
}
