package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** What every light source sends: where it is, how it shines and how it fades. */
abstract class Light(
    position: Vector3f,
    val color: Vector3f,
    private val attenuation: Attenuation
) : Transformable() {

    init {
        translateGlobal(position)
    }

    protected fun send(shader: ShaderProgram, name: String) {
        shader.setUniform("$name.position", getWorldPosition())
        shader.setUniform("$name.color", color)
        shader.setUniform("$name.attenuation", attenuation.factors)
    }
}
