package cga.exercise.components.geometry

import cga.exercise.components.texture.Texture2D
import cga.framework.image.ImageData
import cga.testing.assertRefused
import org.joml.Vector2f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

class MaterialTest {
    private val diffuse = texture()
    private val emissive = texture()
    private val specular = texture()

    @Test
    fun `the exponent is finite and at least 0`() {
        val material = material(0f)
        for (bad in listOf(-1f, -Float.MIN_VALUE, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY)) {
            assertRefused(bad) { material(bad) }
            assertRefused(bad) { material.shininess = bad }
        }
        assertEquals(0f, material.shininess)
        material.shininess = Float.MAX_VALUE
        assertEquals(Float.MAX_VALUE, material.shininess)
    }

    @Test
    fun `as plain data it has every texture in its place`() {
        val material = Material(diffuse, emissive, specular, 7f, Vector2f(2f, 3f))
        val data = material.toFrameMaterial()
        assertSame(diffuse.image, data.diffuse.image)
        assertSame(emissive.image, data.emissive.image)
        assertSame(specular.image, data.specular.image)
        assertEquals(7f, data.shininess)

        material.tcMultiplier.set(9f)
        assertEquals(Vector2f(2f, 3f), data.tcMultiplier, "a frame does not change")
    }

    @Test
    fun `it is thrown away without OpenGL`() {
        material(1f).cleanup()
    }

    private fun material(shininess: Float) = Material(diffuse, emissive, specular, shininess)

    private fun texture() = Texture2D(ImageData.ofColor(1f, 1f, 1f), false)
}
