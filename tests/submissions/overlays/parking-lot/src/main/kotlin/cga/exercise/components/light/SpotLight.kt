package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    position: Vector3f,
    lightCol: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, lightCol, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    // mit L ein und aus
    var on = true

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        if (!on) shaderProgram.setUniform("$name.col", Vector3f(0.0f))
        shaderProgram.setUniform("$name.inner", innerAngle)
        shaderProgram.setUniform("$name.outer", outerAngle)

        val z = getWorldZAxis()
        val dir = viewMatrix.transform(Vector4f(-z.x, -z.y, -z.z, 0.0f))
        shaderProgram.setUniform("$name.dir", Vector3f(dir.x, dir.y, dir.z))
    }
}
