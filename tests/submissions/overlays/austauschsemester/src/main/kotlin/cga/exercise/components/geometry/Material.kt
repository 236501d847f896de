package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50.0f,
    var tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    // name in the shader and texture, the index in the list is the texture unit
    private val maps = listOf("diff", "spec", "emit").zip(listOf(diff, specular, emit))

    fun bind(shaderProgram: ShaderProgram) {
        maps.forEachIndexed { unit, (name, texture) ->
            texture.bind(unit)
            shaderProgram.send("material.$name" to unit)
        }
        shaderProgram.send("material.brillo" to shininess, "repeat" to tcMultiplier)
    }
}
