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
        val counts = listOf(0 to 0, 1 to 0, 1 to 1, 1 to 1, 1 to 1, 1 to 1, 5 to 1, 5 to 1)
        for ((step, count) in Step.entries.zip(counts)) {
            val (points, spots) = count
            lights.switchTo(step)
            val expected =
                members("pointLight", points, listOf("position", "color", "attenuation")) +
                    members("spotLight", spots, listOf("position", "color", "attenuation", "direction", "cone"))
            assertEquals(expected, sent().keys, "$step")
            assertEquals(mapOf("POINT_LIGHTS" to points, "SPOT_LIGHTS" to spots), lights.counts(step), "$step")
        }
    }

    @Test
    fun `back at an earlier step, lights do not attenuate again`() {
        lights.switchTo(Step.FINAL)
        lights.switchTo(Step.SPOT_LIGHT)
        assertEquals(Vector3f(1f, 0f, 0f), sent()["spotLight[0].attenuation"])
        lights.switchTo(Step.ATTENUATION)
        assertEquals(Vector3f(0.5f, 0.05f, 0.01f), sent()["spotLight[0].attenuation"])
    }

    @Test
    fun `the motorcycle's colour is its own light's alone`() {
        lights.switchTo(Step.FINAL)
        val before = sent()
        lights.setMotorcycleColor(Vector3f(0.1f, 0.2f, 0.3f))
        assertEquals(before + ("pointLight[0].color" to Vector3f(0.1f, 0.2f, 0.3f)), sent())
    }

    private fun sent(): Map<String, Any> = RecordingProgram().also { lights.bind(it, Matrix4d()) }.sent

    private fun members(array: String, size: Int, names: List<String>) = (0 until size)
        .flatMap { i -> names.map { "$array[$i].$it" } }
        .toSet()
}
