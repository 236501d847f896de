package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.set
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

data class Material(
    val albedo: Texture2D,
    val glow: Texture2D,
    val gloss: Texture2D,
    val shine: Float = 50.0f,
    val tiling: Vector2f = Vector2f(1.0f)
) {
    fun bind(shader: ShaderProgram) {
        listOf("albedo" to albedo, "gloss" to gloss, "glow" to glow).forEachIndexed { unit, (slot, tex) ->
            tex.bind(unit)
            shader["surf.$slot"] = unit
        }
        shader["surf.shine"] = shine
        shader["u_tiling"] = tiling
    }
}
