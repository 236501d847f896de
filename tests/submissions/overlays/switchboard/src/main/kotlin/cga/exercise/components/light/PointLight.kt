package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(position: Vector3f, val color: Vector3f) : Transformable(), IPointLight, Switchable {
    override var on = true
    protected open val k = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        shaderProgram.setUniform("$name.on", on)
        shaderProgram.setUniform("$name.position", viewMatrix.transformPosition(getWorldPosition()))
        shaderProgram.setUniform("$name.color", color)
        shaderProgram.setUniform("$name.k", k)
    }
}
