package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f
import org.lwjgl.BufferUtils

class Material(
    private val diff: Texture2D,
    private val emit: Texture2D,
    private val specular: Texture2D,
    private val shininess: Float = 50.0f,
    private val tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("diffTex", 0)
        shaderProgram.setUniform("specTex", 1)
        shaderProgram.setUniform("emitTex", 2)
        diff.bind(0)
        specular.bind(1)
        emit.bind(2)
        shaderProgram.setUniform("shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }

    companion object {
        /** A material without pictures: every map is one pixel. */
        fun plain(diffuse: Int, specular: Int, shininess: Float) =
            Material(pixel(diffuse), pixel(0x000000), pixel(specular), shininess)

        private fun pixel(rgb: Int): Texture2D {
            val data = BufferUtils.createByteBuffer(4)
            data.put((rgb shr 16).toByte()).put((rgb shr 8).toByte()).put(rgb.toByte()).put(255.toByte())
            data.flip()
            return Texture2D(data, 1, 1, false)
        }
    }
}
