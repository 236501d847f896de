package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private val modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun getModelMatrix() = Matrix4f(modelMatrix)

    fun getWorldModelMatrix(): Matrix4f {
        return parent?.getWorldModelMatrix()?.mul(modelMatrix) ?: getModelMatrix()
    }

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val rotation = Matrix4f().rotateXYZ(pitch, yaw, roll)
        preTranslate(Vector3f(altMidpoint).negate())
        rotation.mul(modelMatrix, modelMatrix)
        preTranslate(altMidpoint)
    }

    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun preTranslate(deltaPos: Vector3f) {
        val translation = Matrix4f().translation(deltaPos)
        translation.mul(modelMatrix, modelMatrix)
    }

    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = modelMatrix.getTranslation(Vector3f())

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

    fun getXAxis(): Vector3f = modelMatrix.getColumn(0, Vector3f()).normalize()

    fun getYAxis(): Vector3f = modelMatrix.getColumn(1, Vector3f()).normalize()

    fun getZAxis(): Vector3f = modelMatrix.getColumn(2, Vector3f()).normalize()

    fun getWorldXAxis(): Vector3f = getWorldModelMatrix().getColumn(0, Vector3f()).normalize()

    fun getWorldYAxis(): Vector3f = getWorldModelMatrix().getColumn(1, Vector3f()).normalize()

    fun getWorldZAxis(): Vector3f = getWorldModelMatrix().getColumn(2, Vector3f()).normalize()
}
