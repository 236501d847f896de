package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(p: Vector3f, c: Vector3f, private val wi: Float, private val wa: Float) : PointLight(p, c), ISpotLight {
    init {
        k = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        //val r = getWorldZAxis()
        val r = Vector4f(0f, 0f, -1f, 0f)
        r.mul(getWorldModelMatrix())
        r.mul(viewMatrix)
        shaderProgram.setUniform("sld", Vector3f(r.x, r.y, r.z))
        shaderProgram.setUniform("slw", Vector2f(wi, wa))
    }
}
