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
        for ((unit, map) in listOf("uDiffuse" to diff, "uSpecular" to specular, "uEmissive" to emit).withIndex()) {
            map.second.bind(unit)
            shaderProgram.setUniform(map.first, unit)
        }
        shaderProgram.setUniform("uShininess", shininess)
        shaderProgram.setUniform("uTiling", tcMultiplier)
    }
}
