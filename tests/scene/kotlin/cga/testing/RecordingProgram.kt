package cga.testing

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix3fc
import org.joml.Matrix4f
import org.joml.Matrix4fc
import org.joml.Vector2f
import org.joml.Vector2fc
import org.joml.Vector3f
import org.joml.Vector3fc
import org.joml.Vector4f
import org.joml.Vector4fc

/** Remembers what it is sent, copied, in place of sending it to OpenGL. */
class RecordingProgram : ShaderProgram("shaders/scene.vert", "shaders/scene.frag") {
    /** Every uniform that was set and its last value, in the order of first setting. */
    val sent = LinkedHashMap<String, Any>()

    /** The vector sent as [name]. */
    fun vector(name: String): Vector3f = sent.getValue(name) as Vector3f

    override fun setUniform(name: String, value: Int) {
        sent[name] = value
    }

    override fun setUniform(name: String, value: Float) {
        sent[name] = value
    }

    override fun setUniform(name: String, value: Vector2fc) {
        sent[name] = Vector2f(value)
    }

    override fun setUniform(name: String, value: Vector3fc) {
        sent[name] = Vector3f(value)
    }

    override fun setUniform(name: String, value: Vector4fc) {
        sent[name] = Vector4f(value)
    }

    override fun setUniform(name: String, value: Matrix3fc, transpose: Boolean) {
        sent[name] = Matrix3f(value).also { if (transpose) it.transpose() }
    }

    override fun setUniform(name: String, value: Matrix4fc, transpose: Boolean) {
        sent[name] = Matrix4f(value).also { if (transpose) it.transpose() }
    }
}
