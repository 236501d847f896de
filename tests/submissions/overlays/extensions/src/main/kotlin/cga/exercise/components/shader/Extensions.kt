package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/** All uniforms at once: `shader.send("a" to 1.0f, "b" to Vector3f())`. */
fun ShaderProgram.send(vararg uniforms: Pair<String, Any>) = uniforms.forEach { (name, value) ->
    when (value) {
        is Int -> setUniform(name, value)
        is Float -> setUniform(name, value)
        is Vector2f -> setUniform(name, value)
        is Vector3f -> setUniform(name, value)
        is Matrix4f -> setUniform(name, value, false)
        else -> error("no uniform: $name")
    }
}

operator fun Vector3f.plus(other: Vector3f): Vector3f = add(other, Vector3f())
operator fun Vector3f.minus(other: Vector3f): Vector3f = sub(other, Vector3f())
operator fun Vector3f.unaryMinus(): Vector3f = negate(Vector3f())
operator fun Vector3f.times(factor: Float): Vector3f = mul(factor, Vector3f())
operator fun Matrix4f.times(other: Matrix4f): Matrix4f = mul(other, Matrix4f())

/** The matrix with a point (w = 1) and with a direction (w = 0). */
infix fun Matrix4f.point(p: Vector3f): Vector3f = transformPosition(p, Vector3f())
infix fun Matrix4f.direction(d: Vector3f): Vector3f = transformDirection(d, Vector3f())

val Float.deg: Float get() = Math.toRadians(toDouble()).toFloat()
