package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val innerCone: Float,
    private val outerCone: Float
) : PointLight(position, lightColor), ISpotLight {

    private val onColor = Vector3f(lightColor)
    private var on = true

    init {
        attParam = Vector3f(0.5f, 0.05f, 0.01f)
    }

    fun toggle() {
        on = !on
        lightColor = if (on) Vector3f(onColor) else Vector3f(0.0f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        // a direction, so w = 0
        val forward = getWorldZAxis().negate()
        val dir = Vector4f(forward, 0.0f).mul(viewMatrix)
        shaderProgram.setUniform("spotDir", Vector3f(dir.x, dir.y, dir.z))
        shaderProgram.setUniform("spotInner", innerCone)
        shaderProgram.setUniform("spotOuter", outerCone)
    }
}
