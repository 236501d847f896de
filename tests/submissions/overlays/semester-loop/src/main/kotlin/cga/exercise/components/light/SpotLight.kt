package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight(
    lightPos: Vector3f,
    lightColor: Vector3f,
    slot: Int,
    intensity: Float,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(lightPos, lightColor, slot, intensity), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        bind(shaderProgram)
        // z axis: out of the back of the lamp, the same way as toLight
        val back = Matrix3f(viewMatrix).transform(getWorldZAxis())
        shaderProgram.setUniform("spotBack", back)
        shaderProgram.setUniform("spotAngles", Vector2f(innerAngle, outerAngle))
    }
}
