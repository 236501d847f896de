package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    val diffuse: Texture2D,
    val emissive: Texture2D,
    val specular: Texture2D,
    val shininess: Float = 50.0f,
    val tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    fun bind(shader: ShaderProgram) {
        diffuse.bind(0)
        specular.bind(1)
        emissive.bind(2)
        shader.setUniform("material.diffuse", 0)
        shader.setUniform("material.specular", 1)
        shader.setUniform("material.emissive", 2)
        shader.setUniform("material.shininess", shininess)
        shader.setUniform("uvScale", tcMultiplier)
    }
}
