package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    diff: Texture2D,
    emit: Texture2D,
    specular: Texture2D,
    private val shininess: Float = 50.0f,
    private val tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    private val maps = mapOf("mapKd" to diff, "mapKs" to specular, "mapKe" to emit)

    fun bind(shaderProgram: ShaderProgram) {
        maps.entries.forEachIndexed { unit, (name, texture) ->
            texture.bind(unit + 3)
            shaderProgram.send(name to unit + 3)
        }
        shaderProgram.send("k" to shininess, "tiles" to tcMultiplier)
    }
}
