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
        // bind diffuse map
        diff.bind(0)
        // bind specular map
        specular.bind(1)
        // bind emission map
        emit.bind(2)

        shaderProgram.setUniform("material.diffuse", 0)
        shaderProgram.setUniform("material.specular", 1)
        shaderProgram.setUniform("material.emission", 2)
        shaderProgram.setUniform("material.shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }
}
