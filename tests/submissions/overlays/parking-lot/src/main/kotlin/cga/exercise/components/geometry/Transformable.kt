package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    // um die eigenen Achsen
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch)
        modelMatrix.rotateY(yaw)
        modelMatrix.rotateZ(roll)
    }

    // um einen Punkt im Koordinatensystem des Parents
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val m = Matrix4f()
        m.translate(altMidpoint)
        m.rotateX(pitch)
        m.rotateY(yaw)
        m.rotateZ(roll)
        m.translate(Vector3f(altMidpoint).mul(-1.0f))
        m.mul(modelMatrix)
        modelMatrix = m
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val m = Matrix4f()
        m.translate(deltaPos)
        m.mul(modelMatrix)
        modelMatrix = m
    }

    fun scaleLocal(scale: Vector3f) {
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

    fun getWorldModelMatrix(): Matrix4f {
        var world = Matrix4f(modelMatrix)
        if (parent != null) world = parent!!.getWorldModelMatrix().mul(modelMatrix)
        return world
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
