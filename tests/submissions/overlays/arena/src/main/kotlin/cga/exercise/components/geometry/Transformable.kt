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
        tmp.translate(Vector3f(altMidpoint).negate())
        modelMatrix = tmp.mul(modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        modelMatrix = Matrix4f().translate(deltaPos).mul(modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = modelMatrix.getTranslation(Vector3f())

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

    fun getZAxis(): Vector3f = axis(modelMatrix, 2)

    fun getWorldXAxis(): Vector3f = axis(getWorldModelMatrix(), 0)

    fun getWorldYAxis(): Vector3f = axis(getWorldModelMatrix(), 1)

    fun getWorldZAxis(): Vector3f = axis(getWorldModelMatrix(), 2)

    private fun axis(m: Matrix4f, column: Int): Vector3f = m.getColumn(column, Vector3f()).normalize()

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent ?: return Matrix4f(modelMatrix)
        return p.getWorldModelMatrix().mul(modelMatrix)
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
