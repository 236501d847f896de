package cga.measure.twin

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3fc
import org.joml.Matrix4fc
import org.joml.Vector2fc
import org.joml.Vector3fc
import org.joml.Vector4fc

/** One uniform that was sent: its [type] as the twin reads it, and its numbers, matrices by columns. */
internal class SentUniform(
    val type: String,
    val name: String,
    val numbers: FloatArray,
)

/** Remembers all uniforms that it sends, in order, whenever [isRecording]. */
internal class UniformRecorder(
    vertexPath: String,
    fragmentPath: String,
    val constants: Map<String, Int>,
) : ShaderProgram(vertexPath, fragmentPath, constants) {
    /** What was sent since recording began. */
    val sent = ArrayList<SentUniform>()
    var isRecording = false

    override fun setUniform(
        name: String,
        value: Int,
    ) {
        // Small numbers, exact as floats: units of textures, and truth values.
        record("i1", name, value.toFloat())
        super.setUniform(name, value)
    }

    override fun setUniform(
        name: String,
        value: Float,
    ) {
        record("f1", name, value)
        super.setUniform(name, value)
    }

    override fun setUniform(
        name: String,
        value: Vector2fc,
    ) {
        record("f2", name, value.x(), value.y())
        super.setUniform(name, value)
    }

    override fun setUniform(
        name: String,
        value: Vector3fc,
    ) {
        record("f3", name, value.x(), value.y(), value.z())
        super.setUniform(name, value)
    }

    override fun setUniform(
        name: String,
        value: Vector4fc,
    ): Unit = error("the twin knows no uniform of four floats, such as $name")

    override fun setUniform(
        name: String,
        value: Matrix3fc,
        transpose: Boolean,
    ) {
        require(!transpose) { "the twin transposes no matrix, such as $name" }
        record("m3", name, *value.get(FloatArray(9)))
        super.setUniform(name, value, transpose)
    }

    override fun setUniform(
        name: String,
        value: Matrix4fc,
        transpose: Boolean,
    ) {
        require(!transpose) { "the twin transposes no matrix, such as $name" }
        record("m4", name, *value.get(FloatArray(16)))
        super.setUniform(name, value, transpose)
    }

    private fun record(
        type: String,
        name: String,
        vararg numbers: Float,
    ) {
        if (isRecording) sent += SentUniform(type, name, numbers)
    }
}
