package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var parent: Transformable? = null) {
    var mat = Matrix4f()

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        mat.rotateX(pitch)
        mat.rotateY(yaw)
        mat.rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        // erst zum punkt, drehen, wieder zurueck
        val m = Matrix4f()
        m.translate(altMidpoint)
        m.rotateX(pitch)
        m.rotateY(yaw)
        m.rotateZ(roll)
        m.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        m.mul(mat)
        mat = m
        // mat.mul(m)   // falschrum
    }

    fun translateLocal(deltaPos: Vector3f) {
        mat.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val m = Matrix4f()
        m.translate(deltaPos)
        m.mul(mat)
        mat = m
    }

    fun scaleLocal(scale: Vector3f) {
        mat.scale(scale)
    }

    fun getLocalModelMatrix(): Matrix4f {
        return Matrix4f(mat)
    }

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent
        if (p == null) {
            return Matrix4f(mat)
        }
        return p.getWorldModelMatrix().mul(mat)
    }

    fun getPosition(): Vector3f {
        return Vector3f(mat.m30(), mat.m31(), mat.m32())
    }

    fun getWorldPosition(): Vector3f {
        val w = getWorldModelMatrix()
        return Vector3f(w.m30(), w.m31(), w.m32())
    }

    fun getXAxis(): Vector3f = Vector3f(mat.m00(), mat.m01(), mat.m02()).normalize()

    fun getYAxis(): Vector3f = Vector3f(mat.m10(), mat.m11(), mat.m12()).normalize()

    fun getZAxis(): Vector3f = Vector3f(mat.m20(), mat.m21(), mat.m22()).normalize()

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
}
