package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight(
    lightPos: Vector3f,
    lightCol: Vector3f,
    private var innerAngle: Float,
    private var outerAngle: Float
) : PointLight(lightPos, lightCol), ISpotLight {

    override var attParam = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        // Position, Farbe und Attenuation kommen vom PointLight
        super.bind(shaderProgram, name)

        // leuchtet in Richtung der negativen z-Achse
        val richtung = getWorldZAxis().negate()
        richtung.mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform(name + "Dir", richtung)
        shaderProgram.setUniform(name + "Angle", Vector2f(innerAngle, outerAngle))
        //println("spot: " + richtung)
    }
}
