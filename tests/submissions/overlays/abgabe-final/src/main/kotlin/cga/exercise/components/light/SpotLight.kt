package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

/** Angles in radians. The cosines are taken here, so the fragment shader does not need to. */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, color), ISpotLight {

    init {
        attenuation = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        // points back, from the cone to the lamp
        val dir = getWorldZAxis().mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform("$name.direction", dir)
        shaderProgram.setUniform("$name.cosInner", cos(innerAngle))
        shaderProgram.setUniform("$name.cosOuter", cos(outerAngle))
    }
}
