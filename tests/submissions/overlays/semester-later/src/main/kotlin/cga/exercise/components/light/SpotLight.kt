package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import kotlin.math.cos

/**
 * @param innerAngle full light up to this angle (radians)
 * @param outerAngle no light from this angle on (radians)
 */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, color), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, viewMatrix)
        val axisInView = viewMatrix.transformDirection(getWorldZAxis().negate())
        shaderProgram.setUniform(uniformName + "AxisVS", axisInView)
        shaderProgram.setUniform(uniformName + "Cone", Vector2f(cos(innerAngle), cos(outerAngle)))
    }
}
