package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.deg
import cga.exercise.components.shader.point
import cga.exercise.components.shader.send
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos
import kotlin.math.sin

/** Goes round its parent on a circle and always looks at it. */
class TronCamera(
    private val radius: Float,
    private val height: Float,
    private val fov: Float = 90.0f.deg,
    private val ratio: Float = 16.0f / 9.0f
) : Transformable(), ICamera {

    /** Where on the circle: 0 is behind the parent. */
    var angle = 0.0f

    override fun getCalculateViewMatrix(): Matrix4f {
        val toWorld = parent!!.getWorldModelMatrix()
        val eye = toWorld point Vector3f(radius * sin(angle), height, radius * cos(angle))
        val target = toWorld point Vector3f(0.0f, 0.6f, 0.0f)
        return Matrix4f().lookAt(eye, target, Vector3f(0.0f, 1.0f, 0.0f))
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, ratio, 0.1f, 100.0f)

    override fun bind(shader: ShaderProgram) = shader.send(
        "view" to getCalculateViewMatrix(),
        "projection" to getCalculateProjectionMatrix()
    )
}
