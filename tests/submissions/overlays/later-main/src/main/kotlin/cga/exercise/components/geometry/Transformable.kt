package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun getModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }

    fun getWorldModelMatrix(): Matrix4f {
        val world = getModelMatrix()
        if (parent != null) {
            parent!!.getWorldModelMatrix().mul(modelMatrix, world)
        }
        return world
    }

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val m = Matrix4f()
        m.translate(altMidpoint)
        m.rotateXYZ(pitch, yaw, roll)
        m.translate(Vector3f(altMidpoint).negate())
        modelMatrix = m.mul(modelMatrix)
    }

    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun preTranslate(deltaPos: Vector3f) {
        modelMatrix = Matrix4f().translation(deltaPos).mul(modelMatrix)
    }

    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f {
        return Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())
    }

    fun getWorldPosition(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m30(), m.m31(), m.m32())
    }

    fun getXAxis(): Vector3f {
        return Vector3f(modelMatrix.m00(), modelMatrix.m01(), modelMatrix.m02()).normalize()
    }

    fun getYAxis(): Vector3f {
        return Vector3f(modelMatrix.m10(), modelMatrix.m11(), modelMatrix.m12()).normalize()
    }

    fun getZAxis(): Vector3f {
        return Vector3f(modelMatrix.m20(), modelMatrix.m21(), modelMatrix.m22()).normalize()
    }

    fun getWorldXAxis(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m00(), m.m01(), m.m02()).normalize()
    }

    fun getWorldYAxis(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m10(), m.m11(), m.m12()).normalize()
    }

    fun getWorldZAxis(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m20(), m.m21(), m.m22()).normalize()
    }
}
