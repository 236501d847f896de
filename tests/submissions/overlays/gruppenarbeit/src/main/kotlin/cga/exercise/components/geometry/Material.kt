package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.uniforms
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50.0f,
    var tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    // Namen der Sampler im Shader, die Reihenfolge ist die der Texture Units
    private val maps = listOf(
        "farbTex" to diff,
        "leuchtTex" to emit,
        "glanzTex" to specular
    )

    fun bind(shaderProgram: ShaderProgram) = shaderProgram.uniforms {
        maps.forEachIndexed { unit, (name, texture) ->
            texture.bind(unit)
            name set unit
        }
        "haerte" set shininess
        "kachelung" set tcMultiplier
    }
}
