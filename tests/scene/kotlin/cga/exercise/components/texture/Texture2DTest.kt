package cga.exercise.components.texture

import cga.framework.InputError
import cga.framework.image.ImageData
import cga.testing.assertRefused
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.lwjgl.opengl.GL33C.*

class Texture2DTest {
    private val image = ImageData.ofColor(1f, 0.5f, 0f)

    @Test
    fun `it is made, set up and thrown away without OpenGL`() {
        val texture = Texture2D(image, false)
        texture.setTexParams(GL_CLAMP_TO_EDGE, GL_REPEAT, GL_NEAREST, GL_NEAREST)
        texture.cleanup()
    }

    @Test
    fun `unless told otherwise it repeats and is smooth`() {
        assertEquals(listOf(GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR), parameters(Texture2D(image, false)))
        assertEquals(listOf(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR), parameters(Texture2D(image, true)))
    }

    @Test
    fun `its parameters can be set`() {
        val texture = Texture2D(image, true)
        texture.setTexParams(GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT, GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST)
        assertEquals(listOf(GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT, GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST), parameters(texture))
    }

    @Test
    fun `a mipmapped filter without mipmaps is refused`() {
        val texture = Texture2D(image, false)
        val mipmapped =
            listOf(GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR)
        for (filter in mipmapped) {
            assertRefused("0x%X".format(filter)) { texture.setTexParams(GL_CLAMP_TO_EDGE, GL_REPEAT, filter, GL_NEAREST) }
        }
        assertEquals(listOf(GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR), parameters(texture), "after the refusal")
    }

    @Test
    fun `as plain data it is its picture and parameters`() {
        val texture = Texture2D(image, true)
        val data = texture.toFrameTexture()
        texture.setTexParams(GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_NEAREST, GL_NEAREST)
        assertSame(texture.image, data.image)
        assertEquals(
            listOf(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR),
            with(data) { listOf(wrapS, wrapT, minFilter, magFilter) },
        )
    }

    @Test
    fun `it is read from a file`() {
        val level = Texture2D("assets/ground/ground_diffuse.png", false).image.levels.single()
        assertEquals(4 * level.width * level.height, level.rgba.size)
        val error = assertThrows<InputError> { Texture2D("assets/missing.png", false) }
        assertTrue("missing.png" in error.message.orEmpty())
    }

    private fun parameters(texture: Texture2D) = with(texture) { listOf(wrapS, wrapT, minFilter, magFilter) }
}
