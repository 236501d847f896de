package cga.exercise.components.shader

import cga.exercise.components.camera.ICamera
import cga.exercise.components.light.PointLight
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL20.*

// shader["u_name"] = value   (instead of setUniform)

operator fun ShaderProgram.set(name: String, i: Int) = glUniform1i(location(name), i)

operator fun ShaderProgram.set(name: String, f: Float) = glUniform1f(location(name), f)

operator fun ShaderProgram.set(name: String, v: Vector2f) = glUniform2f(location(name), v.x, v.y)

operator fun ShaderProgram.set(name: String, v: Vector3f) = glUniform3f(location(name), v.x, v.y, v.z)

operator fun ShaderProgram.set(name: String, m: Matrix3f) = glUniformMatrix3fv(location(name), false, m.get(FloatArray(9)))

operator fun ShaderProgram.set(name: String, m: Matrix4f) = glUniformMatrix4fv(location(name), false, m.get(FloatArray(16)))

fun ShaderProgram.bindCamera(camera: ICamera) = camera.bind(this)

/** all lights of the game, no matter of what kind, into the array of the shader */
fun ShaderProgram.bindLights(lights: List<PointLight>) {
    lights.forEachIndexed { i, light -> light.bind(this, "lights[$i]") }
    this["u_lightCount"] = lights.size
}
