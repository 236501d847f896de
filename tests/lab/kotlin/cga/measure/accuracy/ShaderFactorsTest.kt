package cga.measure.accuracy

import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ShaderFactorsTest {
    private val down = Vector3f(0f, -2f, 0f)
    private val k = Vector3f(0.5f, 0.05f, 0.01f)

    @Test
    fun `a cone is lit inside, dark outside and half lit between`() {
        // tan 30° = 0.577, tan 45° = 1; the cosine half way between those of 30° and 60° is 0.683, its tangent 1.06939.
        val (inner, outer) = listOf(30.0, 60.0).map { Math.toRadians(it).toFloat() }

        fun at(tangent: Float) = ShaderFactors.cone(Vector3f(3 * tangent, -3f, 0f), down, inner, outer)
        assertEquals(listOf(1f, 1f, 0f), listOf(at(0f), at(0.57f), at(1.74f)))
        assertEquals(0.5f, at(1.06939f), 1e-5f)
    }

    @Test
    fun `equal angles make a step`() {
        assertEquals(1f, ShaderFactors.cone(Vector3f(0.09f, -1f, 0f), down, 0.1f, 0.1f))
        assertEquals(0f, ShaderFactors.cone(Vector3f(0.11f, -1f, 0f), down, 0.1f, 0.1f))
    }

    @Test
    fun `attenuation is the sheet's, and 0 at the light and beyond a float's square`() {
        assertEquals(1f / (0.5f + 0.05f * 5f + 0.01f * 25f), ShaderFactors.attenuation(Vector3f(3f, 0f, -4f), k))
        for (distance in listOf(0f, 2e19f, Float.MAX_VALUE)) assertEquals(0f, ShaderFactors.attenuation(Vector3f(distance, 0f, 0f), k))
    }
}
