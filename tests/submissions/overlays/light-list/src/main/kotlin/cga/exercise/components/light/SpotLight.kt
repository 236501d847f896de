package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

/** angles in radians */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val innerCone: Float,
    private val outerCone: Float,
    attenuation: Vector3f = Vector3f(0.5f, 0.05f, 0.01f)
) : PointLight(position, color, attenuation), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val direction = getWorldZAxis().negate()
        val directionView = direction.mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform("$name.direction", directionView)
        shaderProgram.setUniform("$name.cosInner", Math.cos(innerCone))
        shaderProgram.setUniform("$name.cosOuter", Math.cos(outerCone))
    }
}
