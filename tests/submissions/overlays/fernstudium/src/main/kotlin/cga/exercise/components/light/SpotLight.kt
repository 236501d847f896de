package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/**
 * @param winkelInnen halber Oeffnungswinkel des inneren Kegels [rad]
 * @param winkelAussen halber Oeffnungswinkel des aeusseren Kegels [rad]
 */
class SpotLight(
    position: Vector3f,
    lichtfarbe: Vector3f,
    slot: Int,
    private val winkelInnen: Float,
    private val winkelAussen: Float
) : PointLight(position, lichtfarbe, slot), ISpotLight {

    override val typ: Int = TYP_SPOT

    init {
        abschwaechung.set(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)

        // leuchtet entlang -z, Richtung im Viewspace
        val richtung = getWorldZAxis().negate()
        viewMatrix.transformDirection(richtung)
        shaderProgram.setUniform(feld(name, "Dir"), richtung)

        shaderProgram.setUniform(feld(name, "Inner"), winkelInnen)
        shaderProgram.setUniform(feld(name, "Outer"), winkelAussen)
    }
}
