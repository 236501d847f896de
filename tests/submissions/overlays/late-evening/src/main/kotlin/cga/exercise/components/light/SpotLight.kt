package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f
import kotlin.math.cos

class SpotLight(pos: Vector3f, col: Vector3f, private val gamma: Float, private val phi: Float) : PointLight(pos, col), ISpotLight {

    override val att = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)

        //w = 0, weil Richtung
        val dir = Vector4f(getWorldZAxis().negate(), 0.0f)
        dir.mul(viewMatrix)
        shaderProgram.setUniform("dir$name", Vector3f(dir.x, dir.y, dir.z))

        //Cosinus hier, damit er nicht pro Fragment berechnet wird
        shaderProgram.setUniform("cosGamma$name", cos(gamma))
        shaderProgram.setUniform("cosPhi$name", cos(phi))
    }
}
