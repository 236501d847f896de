package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(position: Vector3f, color: Vector3f, index: Int, private val innen: Float, private val aussen: Float) :
    PointLight(position, color, index), ISpotLight {

    // ueberschreibt die Version ohne viewMatrix, weil hier ein anderes Array befuellt wird
    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        val name = "spotLight[$index]"
        shaderProgram.setUniform("$name.pos", getWorldPosition())
        shaderProgram.setUniform("$name.color", color)

        // +z zeigt vom Licht nach hinten, im Shader wird deswegen mit l und nicht mit -l verglichen
        val richtung = viewMatrix.transformDirection(getWorldZAxis())
        shaderProgram.setUniform("$name.dir", richtung)
        shaderProgram.setUniform("$name.cosInnen", cos(innen))
        shaderProgram.setUniform("$name.cosAussen", cos(aussen))
    }
}
