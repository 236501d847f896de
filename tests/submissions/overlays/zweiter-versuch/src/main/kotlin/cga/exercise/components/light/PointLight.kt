package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * @param platz Index in den Arrays vom Shader (0 = Motorrad, ab 1 die Ecken)
 */
open class PointLight(position: Vector3f, var lichtfarbe: Vector3f, private val platz: Int = 0) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    // letztes Jahr noch mit Kc, Kl, Kq:
    // var attenuation = Vector3f(1.0f, 0.5f, 0.1f)

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("lichtPosition[$platz]", getWorldPosition())
        shaderProgram.setUniform("lichtFarbe[$platz]", lichtfarbe)
    }
}
