package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class SpotLight(position: Vector3f, color: Vector3f, private val innerAngle: Float, private val outerAngle: Float) :
    PointLight(position, color, Vector3f(0.5f, 0.05f, 0.01f)) {

    override fun upload(shader: ShaderProgram, name: String) {
        super.upload(shader, name)
        shader.setVec3("$name.direction", getWorldZAxis().negate())
        shader.setFloat("$name.innerAngle", innerAngle)
        shader.setFloat("$name.outerAngle", outerAngle)
    }
}
