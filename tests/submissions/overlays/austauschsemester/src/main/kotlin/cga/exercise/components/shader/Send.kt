package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/**
 * setUniform for many values, like **kwargs in Python:
 * shader.send("a" to 1.0f, "b" to Vector3f())
 */
fun ShaderProgram.send(vararg values: Pair<String, Any>) {
    for ((name, value) in values) {
        when (value) {
            is Int -> setUniform(name, value)
            is Float -> setUniform(name, value)
            is Vector2f -> setUniform(name, value)
            is Vector3f -> setUniform(name, value)
            is Matrix4f -> setUniform(name, value, false)
            else -> throw IllegalArgumentException("TypeError: $name = $value")
        }
        // debug: println("$name = $value")
    }
}
