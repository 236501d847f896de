package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    uniform: String,
    position: Vector3f,
    lightColor: Vector3f,
    private val gamma: Float,
    private val phi: Float
) : PointLight(uniform, position, lightColor), ISpotLight {
    override val factors = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, "$name.lamp", viewMatrix)
        val modelView = Matrix4f(viewMatrix).mul(getWorldModelMatrix())
        shaderProgram.uniforms["$name.axis"] = modelView.transformDirection(Vector3f(0.0f, 0.0f, -1.0f)).normalize()
        shaderProgram.uniforms["$name.gamma"] = gamma
        shaderProgram.uniforms["$name.phi"] = phi
    }
}
