package cga.exercise.components.shader

import cga.exercise.components.texture.Texture2D
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/** `shader["name"] = value` for everything that can be a uniform. */
operator fun ShaderProgram.set(name: String, value: Any) {
    when (value) {
        is Int -> setUniform(name, value)
        is Float -> setUniform(name, value)
        is Vector2f -> setUniform(name, value)
        is Vector3f -> setUniform(name, value)
        is Matrix4f -> setUniform(name, value, false)
        else -> throw IllegalArgumentException("$name: ${value::class}")
    }
}

fun ShaderProgram.setAll(vararg uniforms: Pair<String, Any>) = uniforms.forEach { (name, value) -> this[name] = value }

/** Each texture gets the unit of its place in the list. */
fun ShaderProgram.setTextures(vararg textures: Pair<String, Texture2D>) =
    textures.forEachIndexed { unit, (name, texture) ->
        texture.bind(unit)
        this[name] = unit
    }
