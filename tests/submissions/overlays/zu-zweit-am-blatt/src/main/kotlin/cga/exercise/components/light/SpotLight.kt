package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(
    position: Vector3f,
    farbe: Vector3f,
    staerke: Float,
    private val winkelInnen: Float,
    private val winkelAussen: Float
) : PointLight(position, farbe, staerke, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name, viewMatrix)
        shaderProgram.setUniform("headBeam.axis", richtungImView(viewMatrix))
        // gleich als Cosinus
        shaderProgram.setUniform("headBeam.full", cos(winkelInnen))
        shaderProgram.setUniform("headBeam.none", cos(winkelAussen))
    }
}
