package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(position: Vector3f, var color: Vector3f) : Transformable(), IPointLight {
    protected open val kConstant = 1.0f
    protected open val kLinear = 0.5f
    protected open val kQuadratic = 0.1f

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        // everything is shaded in view space
        shaderProgram.setUniform("$name.position", viewMatrix.transformPosition(getWorldPosition()))
        shaderProgram.setUniform("$name.color", color)
        shaderProgram.setUniform("$name.k", Vector3f(kConstant, kLinear, kQuadratic))
    }
}
