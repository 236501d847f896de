package cga.exercise.components.light

import cga.exercise.components.geometry.Node
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(private val uniform: String, position: Vector3f, var lightColor: Vector3f) : Node(), IPointLight {
    protected open val factors = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    override fun prepare(shader: ShaderProgram, view: Matrix4f) = bind(shader, uniform, view)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        shaderProgram.uniforms["$name.position"] = getWorldPosition().mulPosition(viewMatrix)
        shaderProgram.uniforms["$name.color"] = lightColor
        shaderProgram.uniforms["$name.factors"] = factors
    }
}
