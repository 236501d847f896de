package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    diff: Texture2D,
    emit: Texture2D,
    specular: Texture2D,
    private val shininess: Float = 50.0f,
    private val tcMultiplier: Vector2f = Vector2f(1.0f, 1.0f)
) {
    // Index = Textureinheit
    private val texturen: Array<Texture2D> = arrayOf(diff, emit, specular)

    fun bind(shaderProgram: ShaderProgram) {
        for (i in 0 until texturen.size) {
            texturen[i].bind(i)
        }
        for (i in 0 until SAMPLER.size) {
            shaderProgram.setUniform(SAMPLER[i], i)
        }
        shaderProgram.setUniform("u_shininess", shininess)
        shaderProgram.setUniform("u_tcScale", tcMultiplier)
    }

    companion object {
        // gleiche Reihenfolge wie texturen
        private val SAMPLER: Array<String> = arrayOf("u_texDiff", "u_texEmit", "u_texSpec")
    }
}
