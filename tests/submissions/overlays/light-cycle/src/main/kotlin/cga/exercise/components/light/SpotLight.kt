package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(name: String, lightColor: Vector3f, position: Vector3f,
                private val innerAngle: Float, private val outerAngle: Float)
    : PointLight(name, lightColor, position), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        super.bind(shaderProgram)
        shaderProgram.setUniform(name + "LightAngle", Vector2f(innerAngle, outerAngle))

        // the light looks along -z, w = 0 because it is a direction
        val dir = Vector4f(getWorldZAxis().negate(), 0.0f).mul(viewMatrix)
        shaderProgram.setUniform(name + "LightDir", Vector3f(dir.x, dir.y, dir.z))
    }
}
