package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /**
     * Returns copy of object model matrix
     * @return modelMatrix
     */
    fun getModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }

    /**
     * Returns multiplication of world and object model matrices.
     * Multiplication has to be recursive for all parents.
     * Hint: scene graph
     * @return world modelMatrix
     */
    fun getWorldModelMatrix(): Matrix4f {
        return parent?.getWorldModelMatrix()?.mul(modelMatrix) ?: Matrix4f(modelMatrix)
    }

    /**
     * Rotates object around its own origin.
     * @param pitch radiant angle around x-axis ccw
     * @param yaw radiant angle around y-axis ccw
     * @param roll radiant angle around z-axis ccw
     */
    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch)
        modelMatrix.rotateY(yaw)
        modelMatrix.rotateZ(roll)
    }

    /**
     * Rotates object around given rotation center.
     * @param pitch radiant angle around x-axis ccw
     * @param yaw radiant angle around y-axis ccw
     * @param roll radiant angle around z-axis ccw
     * @param altMidpoint rotation center
     */
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val matrix = Matrix4f()
        matrix.translate(altMidpoint)
        matrix.rotateX(pitch).rotateY(yaw).rotateZ(roll)
        matrix.translate(Vector3f(altMidpoint).negate())
        modelMatrix = matrix.mul(modelMatrix)
    }

    /**
     * Translates object based on its own coordinate system.
     * @param deltaPos delta positions
     */
    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    /**
     * Translates object based on its parent coordinate system.
     * Hint: this operation has to be left-multiplied
     * @param deltaPos delta positions (x, y, z)
     */
    fun preTranslate(deltaPos: Vector3f) {
        modelMatrix = Matrix4f().translate(deltaPos).mul(modelMatrix)
    }

    /**
     * Scales object related to its own origin
     * @param scale scale factor (x, y, z)
     */
    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    /** Returns position based on aggregated translations. */
    fun getPosition(): Vector3f = modelMatrix.getTranslation(Vector3f())

    /** Returns position based on aggregated translations incl. parents. */
    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

    fun getXAxis(): Vector3f = modelMatrix.getColumn(0, Vector3f()).normalize()
    fun getYAxis(): Vector3f = modelMatrix.getColumn(1, Vector3f()).normalize()
    fun getZAxis(): Vector3f = modelMatrix.getColumn(2, Vector3f()).normalize()

    fun getWorldXAxis(): Vector3f = getWorldModelMatrix().getColumn(0, Vector3f()).normalize()
    fun getWorldYAxis(): Vector3f = getWorldModelMatrix().getColumn(1, Vector3f()).normalize()
    fun getWorldZAxis(): Vector3f = getWorldModelMatrix().getColumn(2, Vector3f()).normalize()
}
