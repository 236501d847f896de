package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val tmp = Matrix4f()
        tmp.translate(altMidpoint)
        tmp.rotateXYZ(pitch, yaw, roll)
        tmp.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        tmp.mul(modelMatrix, modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val tmp = Matrix4f().translate(deltaPos)
        tmp.mul(modelMatrix, modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getWorldModelMatrix(): Matrix4f {
        if (parent == null) return Matrix4f(modelMatrix)
        return parent!!.getWorldModelMatrix().mul(modelMatrix)
    }

    fun getWorldPosition(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m30(), m.m31(), m.m32())
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
