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
        val maps = listOf("diffuse" to diff, "emissive" to emit, "specular" to specular)
        maps.forEachIndexed { unit, (name, texture) ->
            texture.bind(unit)
            shaderProgram.setUniform("material.$name", unit)
        }
        shaderProgram.setUniform("material.shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }
}
