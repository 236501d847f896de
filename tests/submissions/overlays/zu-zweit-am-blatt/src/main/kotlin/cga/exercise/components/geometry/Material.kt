package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50f,
    var tcMultiplier: Vector2f = Vector2f(1f)
) {

    fun bind(shaderProgram: ShaderProgram) {
        textur(shaderProgram, "glowMap", emit, 0)
        textur(shaderProgram, "albedoMap", diff, 1)
        textur(shaderProgram, "mirrorMap", specular, 2)
        shaderProgram.setUniform("hardness", shininess)
        shaderProgram.setUniform("uvRepeat", tcMultiplier)
    }

    private fun textur(shader: ShaderProgram, name: String, bild: Texture2D, einheit: Int) {
        bild.bind(einheit)
        shader.setUniform(name, einheit)
    }
}
