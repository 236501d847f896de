package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

/** M_d, M_s, M_e und k aus der Phong-Formel. */
class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50.0f,
    var tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    fun bind(shaderProgram: ShaderProgram) {
        diff.bind(0)
        specular.bind(1)
        emit.bind(2)

        shaderProgram.setUniform("uMd", 0)
        shaderProgram.setUniform("uMs", 1)
        shaderProgram.setUniform("uMe", 2)
        shaderProgram.setUniform("uShininess", shininess)
        shaderProgram.setUniform("uTcMult", tcMultiplier)
    }
}
