package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    private val diff: Texture2D,
    private val emit: Texture2D,
    private val specular: Texture2D,
    private val shininess: Float = 50f,
    private val tcMultiplier: Vector2f = Vector2f(1f)
) {
    fun bind(shaderProgram: ShaderProgram) {
        diff.bind(0)
        shaderProgram.setUniform("diffTex", 0)
        emit.bind(1)
        shaderProgram.setUniform("emitTex", 1)
        specular.bind(2)
        shaderProgram.setUniform("specTex", 2)

        shaderProgram.setUniform("shine", shininess)
        shaderProgram.setUniform("tcMult", tcMultiplier)
    }
}
