package cga.measure.accuracy

import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector2fc
import org.joml.Vector3f
import org.joml.Vector3fc
import org.joml.Vector4f
import kotlin.math.sqrt

/** The light factors of shaders/scene.frag, operation by operation in floats; what SpotLight sends is asked of it. */
internal object ShaderFactors {
    /** I of a spotlight that shines along [axis]. [fromLight] is of any length. */
    fun cone(
        fromLight: Vector3fc,
        axis: Vector3fc,
        inner: Float,
        outer: Float,
    ): Float {
        val light = SpotLight(Vector3f(), Vector3f(1f), inner, outer)
        light.setLocalModelMatrix(Matrix4f().setColumn(2, Vector4f(-axis.x(), -axis.y(), -axis.z(), 0f)))
        light.bind(Sent, "light", Matrix4d())
        val chord = normalizeOrZero(fromLight).sub(Sent.direction)
        val versine = 0.5f * dot(chord, chord)
        val width = Sent.cone.y - Sent.cone.x
        if (width > 0f) return ((Sent.cone.y - versine) / width).coerceIn(0f, 1f)
        return if (versine <= Sent.cone.y) 1f else 0f
    }

    /** F over the distance [toLight] with the coefficients [k]. */
    fun attenuation(
        toLight: Vector3fc,
        k: Vector3fc,
    ): Float {
        val squared = dot(toLight, toLight)
        if (!(squared > 0f && squared <= Float.MAX_VALUE)) return 0f
        return 1f / maxOf(k.x() + k.y() * sqrt(squared) + k.z() * squared, 1f / MAX_ATTENUATION)
    }

    private fun normalizeOrZero(v: Vector3fc): Vector3f {
        val squared = dot(v, v)
        return if (squared > 0f) v.mul(1f / sqrt(squared), Vector3f()) else Vector3f()
    }

    /** Not JOML's, which may fuse. */
    private fun dot(
        a: Vector3fc,
        b: Vector3fc,
    ): Float = a.x() * b.x() + a.y() * b.y() + a.z() * b.z()

    private const val MAX_ATTENUATION = 1e18f

    /** Stands where the shader stands and keeps what a spotlight sends. */
    private object Sent : ShaderProgram("shaders/scene.vert", "shaders/scene.frag") {
        val direction = Vector3f()
        val cone = Vector2f()

        override fun setUniform(
            name: String,
            value: Vector3fc,
        ) {
            if (name == "light.direction") direction.set(value)
        }

        override fun setUniform(
            name: String,
            value: Vector2fc,
        ) {
            cone.set(value)
        }
    }
}
