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
    // Namen der Uniforms: siehe Liste von Lena (tron_frag.glsl oben)
    fun bind(shaderProgram: ShaderProgram) {
        diff.bind(0)
        shaderProgram.setUniform("mat.diffuse_map", 0)
        specular.bind(1)
        shaderProgram.setUniform("mat.specular_map", 1)
        emit.bind(2)
        shaderProgram.setUniform("mat.emissive_map", 2)
        shaderProgram.setUniform("mat.gloss", shininess)
        shaderProgram.setUniform("uv_scale", tcMultiplier)
    }
}
