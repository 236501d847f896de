package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun getModelMatrix() = Matrix4f(modelMatrix)

    fun getWorldModelMatrix(): Matrix4f =
        if (parent == null) getModelMatrix() else parent!!.getWorldModelMatrix().mul(modelMatrix)

    // um den eigenen Ursprung
    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    // um einen Punkt im Koordinatensystem des Parents
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val rot = Matrix4f().rotateXYZ(pitch, yaw, roll)
        preTranslate(Vector3f(altMidpoint).negate())
        modelMatrix = rot.mul(modelMatrix)
        preTranslate(altMidpoint)
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

    fun getPosition() = spalte(modelMatrix, 3)
    fun getWorldPosition() = spalte(getWorldModelMatrix(), 3)

    fun getXAxis() = spalte(modelMatrix, 0).normalize()
    fun getYAxis() = spalte(modelMatrix, 1).normalize()
    fun getZAxis() = spalte(modelMatrix, 2).normalize()

    fun getWorldXAxis() = spalte(getWorldModelMatrix(), 0).normalize()
    fun getWorldYAxis() = spalte(getWorldModelMatrix(), 1).normalize()
    fun getWorldZAxis() = spalte(getWorldModelMatrix(), 2).normalize()

    private fun spalte(m: Matrix4f, i: Int): Vector3f = m.getColumn(i, Vector3f())
}
