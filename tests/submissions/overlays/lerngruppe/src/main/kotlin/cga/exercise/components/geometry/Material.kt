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

    fun bind(shaderProgram: ShaderProgram) {
        // M_e
        emit.bind(0)
        shaderProgram.setUniform("glowTexture", 0)
        // M_d
        diff.bind(1)
        shaderProgram.setUniform("paintTexture", 1)
        // M_s und k
        specular.bind(2)
        shaderProgram.setUniform("glossTexture", 2)
        shaderProgram.setUniform("glossExponent", shininess)

        shaderProgram.setUniform("textureRepeat", tcMultiplier)
    }
}
