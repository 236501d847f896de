package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

/**
 * @param gamma Winkel des inneren Kegels (rad)
 * @param phi Winkel des aeusseren Kegels (rad)
 */
class SpotLight(
    position: Vector3f,
    lightCol: Vector3f,
    private val gamma: Float,
    private val phi: Float
) : PointLight(position, lightCol, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        // Richtung: -z der Lichtquelle, im Viewspace (w = 0, weil Vektor und kein Punkt)
        val dir = Vector4f(getWorldZAxis().negate(), 0.0f).mul(viewMatrix)
        shaderProgram.setUniform("$name.dir", Vector3f(dir.x, dir.y, dir.z))
        shaderProgram.setUniform("$name.gamma", gamma)
        shaderProgram.setUniform("$name.phi", phi)
    }
}
