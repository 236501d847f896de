package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** What all lights have: a place, a colour and the constants of the attenuation. */
abstract class Light(position: Vector3f, var color: Vector3f, private val k: Vector3f) : Transformable() {
    protected abstract val type: Int

    init {
        translateGlobal(position)
    }

    protected fun bindCommon(shader: ShaderProgram, name: String) {
        shader.setUniform("$name.type", type)
        shader.setUniform("$name.position", getWorldPosition())
        shader.setUniform("$name.color", color)
        shader.setUniform("$name.k", k)
    }
}
