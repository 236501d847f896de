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
        bindMap(shaderProgram, "map_e", emit, 0)
        bindMap(shaderProgram, "map_d", diff, 1)
        bindMap(shaderProgram, "map_s", specular, 2)
        shaderProgram.setUniform("k", shininess)
        shaderProgram.setUniform("kacheln", tcMultiplier)
    }

    private fun bindMap(shaderProgram: ShaderProgram, name: String, textur: Texture2D, unit: Int) {
        textur.bind(unit)
        shaderProgram.setUniform(name, unit)
    }
}
