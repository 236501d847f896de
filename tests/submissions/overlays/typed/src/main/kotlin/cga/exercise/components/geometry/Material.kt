package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

data class Material(
    val diff: Texture2D,
    val emit: Texture2D,
    val specular: Texture2D,
    val shininess: Float = 50.0f,
    val tiling: Vector2f = Vector2f(1.0f, 1.0f)
) {
    fun bind(shaderProgram: ShaderProgram) {
        diff.bind(0)
        emit.bind(1)
        specular.bind(2)
        shaderProgram.setUniform("u_diffuse", 0)
        shaderProgram.setUniform("u_emissive", 1)
        shaderProgram.setUniform("u_specular", 2)
        shaderProgram.setUniform("u_shininess", shininess)
        shaderProgram.setUniform("u_tiling", tiling)
    }
}
