package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/**
 * angle.x = innerer Kegel, angle.y = aeusserer Kegel, in Grad
 */
class SpotLight(lightPos: Vector3f, lightCol: Vector3f, angle: Vector2f) : PointLight(lightPos, lightCol), ISpotLight {

    override var lightAttParam = Vector3f(0.5f, 0.05f, 0.01f)

    private val kegel = Vector2f(Math.toRadians(angle.x), Math.toRadians(angle.y))

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        shaderProgram.setUniform(name + "LightAngle", kegel)
        // Richtung in den View Space, nur drehen
        val richtung = getWorldZAxis().negate()
        viewMatrix.transformDirection(richtung)
        shaderProgram.setUniform(name + "LightDir", richtung)
    }
}
