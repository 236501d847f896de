package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(position: Vector3f, lightColor: Vector3f, innerDeg: Float, outerDeg: Float) :
    PointLight(position, lightColor), ISpotLight {

    private val gamma = Math.toRadians(innerDeg.toDouble()).toFloat()
    private val phi = Math.toRadians(outerDeg.toDouble()).toFloat()

    init {
        attenuation.set(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val dir = Vector4f(getWorldZAxis().negate(), 0.0f).mul(viewMatrix)
        shaderProgram.setUniform(name + "_dir", Vector3f(dir.x, dir.y, dir.z))
        shaderProgram.setUniform(name + "_gamma", gamma)
        shaderProgram.setUniform(name + "_phi", phi)
    }
}
