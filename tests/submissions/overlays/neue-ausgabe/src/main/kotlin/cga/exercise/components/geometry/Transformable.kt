package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun getModelMatrix() = Matrix4f(modelMatrix)

    fun getWorldModelMatrix(): Matrix4f {
        val result = Matrix4f(modelMatrix)
        parent?.let { result.mulLocal(it.getWorldModelMatrix()) } // parent * modelMatrix
        return result
    }

    // Transformationen

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val rotation = Matrix4f().rotateXYZ(pitch, yaw, roll)
        preTranslate(Vector3f(altMidpoint).negate())
        modelMatrix = rotation.mul(modelMatrix)
        preTranslate(altMidpoint)
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

    // Positionen und Achsen

    fun getPosition() = column(getModelMatrix(), 3)
    fun getWorldPosition() = column(getWorldModelMatrix(), 3)

    fun getXAxis() = column(getModelMatrix(), 0).normalize()
    fun getYAxis() = column(getModelMatrix(), 1).normalize()
    fun getZAxis() = column(getModelMatrix(), 2).normalize()

    fun getWorldXAxis() = column(getWorldModelMatrix(), 0).normalize()
    fun getWorldYAxis() = column(getWorldModelMatrix(), 1).normalize()
    fun getWorldZAxis() = column(getWorldModelMatrix(), 2).normalize()

    private fun column(m: Matrix4f, nr: Int): Vector3f = m.getColumn(nr, Vector3f())
}
