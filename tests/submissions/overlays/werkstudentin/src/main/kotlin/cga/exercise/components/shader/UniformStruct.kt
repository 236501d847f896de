package cga.exercise.components.shader

import org.joml.Vector2f
import org.joml.Vector3f

/** The members of a struct in the shader: `shader.struct("headlamp") { "axis" set direction }` */
class UniformStruct(private val shader: ShaderProgram, private val name: String) {

    infix fun String.set(value: Vector2f) = shader.setUniform("$name.$this", value)

    infix fun String.set(value: Vector3f) = shader.setUniform("$name.$this", value)
}

fun ShaderProgram.struct(name: String, members: UniformStruct.() -> Unit) = UniformStruct(this, name).members()
