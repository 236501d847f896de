package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(
    private var modelMatrix: Matrix4f = Matrix4f(),
    var parent: Transformable? = null
) {

    /** @return a copy of the local matrix */
    fun getModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }

    /** @return the matrix from local space to world space, through all parents */
    fun getWorldModelMatrix(): Matrix4f {
        val result = Matrix4f(modelMatrix)
        var ancestor = parent
        while (ancestor != null) {
            result.mulLocal(ancestor.modelMatrix)
            ancestor = ancestor.parent
        }
        return result
    }

    // ---------- local transformations ----------

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    // ---------- transformations in the space of the parent ----------

    fun preTranslate(deltaPos: Vector3f) {
        modelMatrix.translateLocal(deltaPos)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val rotation = Matrix4f()
        rotation.translate(altMidpoint)
        rotation.rotateXYZ(pitch, yaw, roll)
        rotation.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        modelMatrix = rotation.mul(modelMatrix)
    }

    // ---------- getters ----------

    fun getPosition(): Vector3f = positionOf(modelMatrix)

    fun getWorldPosition(): Vector3f = positionOf(getWorldModelMatrix())

    fun getXAxis(): Vector3f = axisOf(modelMatrix, 0)

    fun getYAxis(): Vector3f = axisOf(modelMatrix, 1)

    fun getZAxis(): Vector3f = axisOf(modelMatrix, 2)

    fun getWorldXAxis(): Vector3f = axisOf(getWorldModelMatrix(), 0)

    fun getWorldYAxis(): Vector3f = axisOf(getWorldModelMatrix(), 1)

    fun getWorldZAxis(): Vector3f = axisOf(getWorldModelMatrix(), 2)

    private companion object {
        fun positionOf(matrix: Matrix4f): Vector3f = matrix.getTranslation(Vector3f())

        fun axisOf(matrix: Matrix4f, column: Int): Vector3f = matrix.getColumn(column, Vector3f()).normalize()
    }
}
