package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    private val diff: Texture2D,
    private val emit: Texture2D,
    private val specular: Texture2D,
    private val shininess: Float = 50.0f,
    private val tiling: Vector2f? = null
) {
    fun bind(program: ShaderProgram) {
        for ((unit, map) in listOf("diffuseMap" to diff, "emissiveMap" to emit, "specularMap" to specular).withIndex()) {
            map.second.bind(unit)
            program.setUniform(map.first, unit)
        }
        program.setUniform("shininess", shininess)
        if (tiling != null) program.setUniform("tiling", tiling)
    }
}
