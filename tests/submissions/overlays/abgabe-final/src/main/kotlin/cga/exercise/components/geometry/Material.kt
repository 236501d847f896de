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
        bindTexture(shaderProgram, "material_emit", emit, 0)
        bindTexture(shaderProgram, "material_diff", diff, 1)
        bindTexture(shaderProgram, "material_spec", specular, 2)
        shaderProgram.setUniform("material_shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }

    private fun bindTexture(shaderProgram: ShaderProgram, name: String, texture: Texture2D, unit: Int) {
        texture.bind(unit)
        shaderProgram.setUniform(name, unit)
    }
}
