package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    private val diff: Texture2D,
    private val emit: Texture2D,
    private val specular: Texture2D,
    private val shininess: Float = 50.0f,
    private val repeat: Vector2f = Vector2f(1.0f)
) {
    fun bind(shaderProgram: ShaderProgram) {
        val uniforms = shaderProgram.uniforms
        for ((unit, entry) in mapOf("specular" to specular, "diffuse" to diff, "emissive" to emit).entries.withIndex()) {
            entry.value.bind(unit)
            uniforms["material." + entry.key] = unit
        }
        uniforms["material.shininess"] = shininess
        uniforms["repeat"] = repeat
    }
}
