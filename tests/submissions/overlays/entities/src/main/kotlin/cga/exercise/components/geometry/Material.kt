package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    diff: Texture2D,
    emit: Texture2D,
    specular: Texture2D,
    val shininess: Float = 50.0f,
    private val tiling: Vector2f = Vector2f(1.0f)
) {
    private val maps = mapOf("map_diffuse" to diff, "map_specular" to specular, "map_emissive" to emit)

    fun bind(shaderProgram: ShaderProgram) {
        var unit = 0
        for ((name, texture) in maps) {
            texture.bind(unit)
            shaderProgram.setUniform(name, unit++)
        }
        shaderProgram.setUniform("shininess", shininess)
        shaderProgram.setUniform("tiling", tiling)
    }
}
