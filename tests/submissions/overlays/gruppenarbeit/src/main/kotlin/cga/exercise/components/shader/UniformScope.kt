package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/**
 * Little helper, so that we can write
 *
 *     shader.uniforms {
 *         "name" set value
 *     }
 */
class UniformScope(private val shader: ShaderProgram) {
    infix fun String.set(value: Int) = shader.setUniform(this, value)

    infix fun String.set(value: Float) = shader.setUniform(this, value)

    infix fun String.set(value: Vector2f) = shader.setUniform(this, value)

    infix fun String.set(value: Vector3f) = shader.setUniform(this, value)

    infix fun String.set(value: Matrix4f) = shader.setUniform(this, value, false)
}

inline fun ShaderProgram.uniforms(block: UniformScope.() -> Unit) = UniformScope(this).block()
