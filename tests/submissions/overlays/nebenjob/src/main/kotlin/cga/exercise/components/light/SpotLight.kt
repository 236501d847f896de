package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(wo: Vector3f, farbe: Vector3f, private val winn: Float, private val waus: Float) :
    PointLight(wo, farbe), ISpotLight {

    init {
        k = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)

        // leuchtet nach -z, muss in viewspace
        val z = getWorldZAxis()
        val dir = Vector4f(-z.x, -z.y, -z.z, 0.0f)
        dir.mul(viewMatrix)
        shaderProgram.setUniform("dir$name", Vector3f(dir.x, dir.y, dir.z))

        // bogenmass
        shaderProgram.setUniform("inn$name", winn)
        shaderProgram.setUniform("aus$name", waus)
        // println("spot $dir")
    }
}
