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
    fun bind(shader: ShaderProgram) {
        bindTexture(shader, emit, "material_emissive", 0)
        bindTexture(shader, diff, "material_diffuse", 1)
        bindTexture(shader, specular, "material_specular", 2)
        shader.setUniform("material_shininess", shininess)
        shader.setUniform("tcMultiplier", tcMultiplier)
    }

    private fun bindTexture(shader: ShaderProgram, texture: Texture2D, name: String, unit: Int) {
        texture.bind(unit)
        shader.setUniform(name, unit)
    }
}
