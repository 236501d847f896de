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
        tmp.mul(modelMatrix)
        modelMatrix = tmp
        //modelMatrix.mul(tmp)  // geht nicht, dreht sich komisch
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val t = Matrix4f()
        t.translate(deltaPos)
        t.mul(modelMatrix, modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f {
        return Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())
    }

    fun getWorldPosition(): Vector3f {
        val w = getWorldModelMatrix()
        return Vector3f(w.m30(), w.m31(), w.m32())
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
        val w = getWorldModelMatrix()
        return Vector3f(w.m00(), w.m01(), w.m02()).normalize()
    }

    fun getWorldYAxis(): Vector3f {
        val w = getWorldModelMatrix()
        return Vector3f(w.m10(), w.m11(), w.m12()).normalize()
    }

    fun getWorldZAxis(): Vector3f {
        val w = getWorldModelMatrix()
        return Vector3f(w.m20(), w.m21(), w.m22()).normalize()
    }

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent
        if (p == null) {
            return getLocalModelMatrix()
        } else {
            return p.getWorldModelMatrix().mul(modelMatrix)
        }
    }

    fun getLocalModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }
}
