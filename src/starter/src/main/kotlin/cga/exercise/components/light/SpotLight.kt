// solution
package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float,
    attenuation: Vector3f = Vector3f(0.5f, 0.05f, 0.01f)
) : PointLight(position, lightColor, attenuation), ISpotLight {
    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        // It shines along its own negative z axis.
        val direction = viewMatrix.transformDirection(getWorldZAxis().negate())
        shaderProgram.setUniform("$name.direction", direction)
        shaderProgram.setUniform("$name.innerAngle", innerAngle)
        shaderProgram.setUniform("$name.outerAngle", outerAngle)
    }
}
// end of solution
