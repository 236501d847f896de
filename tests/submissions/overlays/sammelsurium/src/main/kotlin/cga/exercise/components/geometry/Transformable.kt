package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /** copy, so nobody changes our matrix from outside */
    fun getModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }

    fun getWorldModelMatrix(): Matrix4f {
        val result = getModelMatrix()
        var p = parent
        while (p != null) {
            result.mulLocal(p.modelMatrix)
            p = p.parent
        }
        return result
    }

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch)
        modelMatrix.rotateY(yaw)
        modelMatrix.rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val drehung = Matrix4f()
        drehung.translate(altMidpoint)
        drehung.rotateXYZ(pitch, yaw, roll)
        drehung.translate(Vector3f(altMidpoint).mul(-1f))
        modelMatrix.mulLocal(drehung)
    }

    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun preTranslate(deltaPos: Vector3f) {
        modelMatrix.translateLocal(deltaPos)
    }

    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())

    fun getWorldPosition(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m30(), m.m31(), m.m32())
    }

    fun getXAxis(): Vector3f = Vector3f(modelMatrix.m00(), modelMatrix.m01(), modelMatrix.m02()).normalize()
    fun getYAxis(): Vector3f = Vector3f(modelMatrix.m10(), modelMatrix.m11(), modelMatrix.m12()).normalize()
    fun getZAxis(): Vector3f = Vector3f(modelMatrix.m20(), modelMatrix.m21(), modelMatrix.m22()).normalize()

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
