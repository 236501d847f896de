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

    // Reihenfolge der Units wie letztes Jahr: emit, spec, diff
    fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("leuchtTextur", 0)
        shaderProgram.setUniform("glanzTextur", 1)
        shaderProgram.setUniform("diffusTextur", 2)
        emit.bind(0)
        specular.bind(1)
        diff.bind(2)

        shaderProgram.setUniform("kacheln", tcMultiplier)
        shaderProgram.setUniform("glanzExponent", shininess)
    }
}
