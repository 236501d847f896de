package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var mm: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        mm.rotateX(pitch)
        mm.rotateY(yaw)
        mm.rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val t = Matrix4f()
        t.translate(altMidpoint)
        t.rotateX(pitch).rotateY(yaw).rotateZ(roll)
        t.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        mm = t.mul(mm)
    }

    fun translateLocal(deltaPos: Vector3f) {
        mm.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        mm.translateLocal(deltaPos)
    }

    fun scaleLocal(scale: Vector3f) {
        mm.scale(scale)
    }

    fun getPosition() = Vector3f(mm.m30(), mm.m31(), mm.m32())

    fun getWorldPosition(): Vector3f {
        val w = getWorldModelMatrix()
        return Vector3f(w.m30(), w.m31(), w.m32())
    }

    fun getZAxis() = Vector3f(mm.m20(), mm.m21(), mm.m22()).normalize()

    fun getWorldZAxis(): Vector3f {
        val w = getWorldModelMatrix()
        return Vector3f(w.m20(), w.m21(), w.m22()).normalize()
    }

    fun getWorldModelMatrix(): Matrix4f {
        if (parent == null) return Matrix4f(mm)
        return parent!!.getWorldModelMatrix().mul(mm)
    }

    fun getLocalModelMatrix() = Matrix4f(mm)
}
