package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private val modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun getModelMatrix() = Matrix4f(modelMatrix)

    fun getWorldModelMatrix(): Matrix4f = parent?.getWorldModelMatrix()?.mul(modelMatrix) ?: getModelMatrix()

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        Matrix4f()
            .translate(altMidpoint)
            .rotateXYZ(pitch, yaw, roll)
            .translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
            .mul(modelMatrix, modelMatrix)
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

    fun getPosition(): Vector3f = modelMatrix.column(3)

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().column(3)

    fun getXAxis(): Vector3f = modelMatrix.column(0).normalize()

    fun getYAxis(): Vector3f = modelMatrix.column(1).normalize()

    fun getZAxis(): Vector3f = modelMatrix.column(2).normalize()

    fun getWorldXAxis(): Vector3f = getWorldModelMatrix().column(0).normalize()

    fun getWorldYAxis(): Vector3f = getWorldModelMatrix().column(1).normalize()

    fun getWorldZAxis(): Vector3f = getWorldModelMatrix().column(2).normalize()

    private fun Matrix4f.column(i: Int) = getColumn(i, Vector3f())
}
