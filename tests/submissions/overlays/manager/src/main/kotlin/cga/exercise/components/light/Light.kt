package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

abstract class Light(position: Vector3f, var color: Vector3f, val attenuation: Vector3f) : Transformable() {

    init {
        translateGlobal(position)
    }

    /** Sets the members of the struct [name] in the shader. */
    open fun upload(shader: ShaderProgram, name: String) {
        shader.setVec3("$name.position", getWorldPosition())
        shader.setVec3("$name.color", color)
        shader.setVec3("$name.attenuation", attenuation)
    }
}
