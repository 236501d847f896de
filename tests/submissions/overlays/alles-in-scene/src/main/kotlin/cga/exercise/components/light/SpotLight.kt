package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(pos: Vector3f, farbe: Vector3f, private val innen: Float, private val aussen: Float) : PointLight(pos, farbe), ISpotLight {

    init {
        att = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val mv = Matrix4f(viewMatrix).mul(getWorldModelMatrix())
        val dir = mv.transformDirection(Vector3f(0.0f, 0.0f, -1.0f))
        shaderProgram.setUniform("spot_dir", dir)
        shaderProgram.setUniform("spot_innen", innen)
        shaderProgram.setUniform("spot_aussen", aussen)
    }
}
