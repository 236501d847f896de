package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    private val diff: Texture2D,
    private val emit: Texture2D,
    private val specular: Texture2D,
    private val shininess: Float = 50.0f,
    private val tcMultiplier: Vector2f = Vector2f(1.0f)
) {

    fun bind(shaderProgram: ShaderProgram) {
        diff.bind(ALBEDO_UNIT)
        specular.bind(GLOSS_UNIT)
        emit.bind(GLOW_UNIT)

        shaderProgram.setUniform("albedoMap", ALBEDO_UNIT)
        shaderProgram.setUniform("glossMap", GLOSS_UNIT)
        shaderProgram.setUniform("glowMap", GLOW_UNIT)

        shaderProgram.setUniform("glossExponent", shininess)
        shaderProgram.setUniform("tiling", tcMultiplier)
    }

    private companion object {
        const val ALBEDO_UNIT = 0
        const val GLOSS_UNIT = 1
        const val GLOW_UNIT = 2
    }
}
