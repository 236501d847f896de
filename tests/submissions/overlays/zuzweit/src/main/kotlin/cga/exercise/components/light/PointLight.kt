package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(startPosition: Vector3f, var farbe: Vector3f) : Transformable(), IPointLight {

    // Kc, Kl, Kq
    protected open val daempfung = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(startPosition)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        val posImView = viewMatrix.transformPosition(getWorldPosition())
        shaderProgram.setUniform("$name.posView", posImView)
        shaderProgram.setUniform("$name.color", farbe)
        shaderProgram.setUniform("$name.att", daempfung)
    }
}
