package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var matrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    // recursive: parent * me (JOML overwrites the left matrix, so always work with a copy!!)
    fun getWorldModelMatrix(): Matrix4f = parent?.getWorldModelMatrix()?.mul(matrix) ?: getModelMatrix()

    fun getModelMatrix() = Matrix4f(matrix)

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        matrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        // read from right to left: point to origin, rotate, back again
        matrix = Matrix4f()
            .translate(altMidpoint)
            .rotateXYZ(pitch, yaw, roll)
            .translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
            .mul(matrix)
    }

    fun translate(deltaPos: Vector3f) {
        matrix.translate(deltaPos)
    }

    fun preTranslate(deltaPos: Vector3f) {
        matrix = Matrix4f().translate(deltaPos).mul(matrix)
    }

    fun scale(scale: Vector3f) {
        matrix.scale(scale)
    }

    // column i of a matrix
    private fun col(m: Matrix4f, i: Int) = Vector3f(m.get(i, 0), m.get(i, 1), m.get(i, 2))

    fun getPosition() = col(matrix, 3)
    fun getXAxis() = col(matrix, 0).normalize()
    fun getYAxis() = col(matrix, 1).normalize()
    fun getZAxis() = col(matrix, 2).normalize()

    fun getWorldPosition() = col(getWorldModelMatrix(), 3)
    fun getWorldXAxis() = col(getWorldModelMatrix(), 0).normalize()
    fun getWorldYAxis() = col(getWorldModelMatrix(), 1).normalize()
    fun getWorldZAxis() = col(getWorldModelMatrix(), 2).normalize()
}
