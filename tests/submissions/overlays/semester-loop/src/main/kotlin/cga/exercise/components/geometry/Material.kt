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
        val maps = listOf("matEmissive" to emit, "matDiffuse" to diff, "matSpecular" to specular)
        for ((unit, map) in maps.withIndex()) {
            map.second.bind(unit)
            shaderProgram.setUniform(map.first, unit)
        }
        shaderProgram.setUniform("matShininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }
}
