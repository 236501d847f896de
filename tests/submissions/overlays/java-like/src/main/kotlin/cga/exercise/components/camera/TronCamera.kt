package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera : Transformable, ICamera {

    private var fieldOfView: Float
    private var aspectRatio: Float

    constructor(fieldOfView: Float, aspectRatio: Float) : super() {
        this.fieldOfView = fieldOfView
        this.aspectRatio = aspectRatio
    }

    fun getFieldOfView(): Float {
        return this.fieldOfView
    }

    fun setFieldOfView(fieldOfView: Float) {
        this.fieldOfView = fieldOfView
    }

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye: Vector3f = this.getWorldPosition()
        val center: Vector3f = Vector3f(eye).sub(this.getWorldZAxis())
        val up: Vector3f = this.getWorldYAxis()
        return Matrix4f().lookAt(eye, center, up)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(this.fieldOfView, this.aspectRatio, 0.1f, 100.0f)
    }

    /** The camera's place in the world, out of the inverse of the view matrix. */
    fun getEyePoint(): Vector3f {
        return this.getCalculateViewMatrix().invert().getTranslation(Vector3f())
    }

    override fun bind(shader: ShaderProgram) {
        throw UnsupportedOperationException("see UniformSender.sendCamera")
    }
}
