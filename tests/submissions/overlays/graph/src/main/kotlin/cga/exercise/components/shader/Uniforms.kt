package cga.exercise.components.shader

import org.joml.Matrix4fc
import org.joml.Vector2fc
import org.joml.Vector3fc
import org.lwjgl.opengl.GL20.*

/** The uniforms of one program, each looked up once. */
class Uniforms(private val program: Int) {
    private val locations = mutableMapOf<String, Int>()

    private fun location(name: String): Int = locations.computeIfAbsent(name) { glGetUniformLocation(program, it) }

    operator fun set(name: String, value: Any) {
        val at = location(name)
        if (at < 0) return
        when (value) {
            is Int -> glUniform1i(at, value)
            is Float -> glUniform1f(at, value)
            is Vector2fc -> glUniform2f(at, value.x(), value.y())
            is Vector3fc -> glUniform3f(at, value.x(), value.y(), value.z())
            is Matrix4fc -> glUniformMatrix4fv(at, false, value.get(FloatArray(16)))
            else -> throw IllegalArgumentException("$name: $value")
        }
    }
}
