package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

/** The textures and constants of a surface. */
class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50.0f,
    var tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    /** Binds each texture to a unit of its own and tells the shader where to find it. */
    fun bind(shaderProgram: ShaderProgram) {
        bindTexture(shaderProgram, emit, "emissiveMap", EMISSIVE_UNIT)
        bindTexture(shaderProgram, diff, "diffuseMap", DIFFUSE_UNIT)
        bindTexture(shaderProgram, specular, "specularMap", SPECULAR_UNIT)
        shaderProgram.setUniform("shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }

    private fun bindTexture(shaderProgram: ShaderProgram, texture: Texture2D, sampler: String, unit: Int) {
        texture.bind(unit)
        shaderProgram.setUniform(sampler, unit)
    }

    companion object {
        private const val EMISSIVE_UNIT = 0
        private const val DIFFUSE_UNIT = 1
        private const val SPECULAR_UNIT = 2
    }
}
