package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.setAll
import cga.exercise.components.shader.setTextures
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

data class Material(
    val diff: Texture2D,
    val emit: Texture2D,
    val spec: Texture2D,
    val shininess: Float = 50f,
    val tiling: Vector2f = Vector2f(1f)
) {
    fun bind(shader: ShaderProgram) {
        shader.setTextures("map.diff" to diff, "map.spec" to spec, "map.emit" to emit)
        shader.setAll("map.shininess" to shininess, "tiling" to tiling)
    }
}
