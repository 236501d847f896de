package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50.0f,
    var tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    companion object {
        // texture units
        const val DIFFUSE_UNIT = 0
        const val SPECULAR_UNIT = 1
        const val EMISSION_UNIT = 2
    }

    fun bind(shaderProgram: ShaderProgram) {
        diff.bind(DIFFUSE_UNIT)
        shaderProgram.setUniform("mtl.diffuseMap", DIFFUSE_UNIT)
        specular.bind(SPECULAR_UNIT)
        shaderProgram.setUniform("mtl.specularMap", SPECULAR_UNIT)
        emit.bind(EMISSION_UNIT)
        shaderProgram.setUniform("mtl.emissionMap", EMISSION_UNIT)

        shaderProgram.setUniform("mtl.shininess", shininess)
        shaderProgram.setUniform("texRepeat", tcMultiplier)
    }
}
