package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/** Looks from one point of its parent's space to another. */
class TronCamera : Transformable(), ICamera {
    private lateinit var m_eye: Vector3f
    private lateinit var m_target: Vector3f
    private var m_fov: Float = Math.toRadians(90.0).toFloat()
    private var m_aspect: Float = 16.0f / 9.0f

    fun setEye(eye: Vector3f) {
        this.m_eye = eye
    }

    fun setTarget(target: Vector3f) {
        this.m_target = target
    }

    override fun getCalculateViewMatrix(): Matrix4f {
        val toWorld: Matrix4f = getWorldModelMatrix()
        val eye: Vector3f = toWorld.transformPosition(m_eye, Vector3f())
        val target: Vector3f = toWorld.transformPosition(m_target, Vector3f())
        return Matrix4f().lookAt(eye, target, Vector3f(0.0f, 1.0f, 0.0f))
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(m_fov, m_aspect, 0.1f, 100.0f)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("uView", getCalculateViewMatrix(), false)
        shader.setUniform("uProjection", getCalculateProjectionMatrix(), false)
    }
}
