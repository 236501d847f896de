package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /** Turns about the object's own axes. */
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    /** Turns about a point of the parent's space. */
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val rotation = Matrix4f()
            .translate(altMidpoint)
            .rotateXYZ(pitch, yaw, roll)
            .translate(Vector3f(altMidpoint).negate())
        modelMatrix = rotation.mul(modelMatrix)
    }

    /** Moves along the object's own axes. */
    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    /** Moves along the axes of the parent's space. */
    fun translateGlobal(deltaPos: Vector3f) {
        modelMatrix = Matrix4f().translate(deltaPos).mul(modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
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

    fun getWorldModelMatrix(): Matrix4f {
        val world = Matrix4f(modelMatrix)
        parent?.getWorldModelMatrix()?.mul(modelMatrix, world)
        return world
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
