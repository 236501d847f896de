package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Quaternionf
import org.joml.Vector3f

/**
 * An object in the scene: a model matrix and, if it has one, a parent.
 */
open class Transformable(protected val modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /** Rotates the object around its own origin. */
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotate(Quaternionf().rotateXYZ(pitch, yaw, roll))
    }

    /** Rotates the object around the given point, which is in the coordinate system of the parent. */
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val q = Quaternionf().rotateXYZ(pitch, yaw, roll)
        val m = Matrix4f().rotateAround(q, altMidpoint.x, altMidpoint.y, altMidpoint.z)
        modelMatrix.mulLocal(m)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        modelMatrix.translateLocal(deltaPos)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = modelMatrix.getTranslation(Vector3f())

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

    fun getXAxis(): Vector3f = axis(modelMatrix, 0)
    fun getYAxis(): Vector3f = axis(modelMatrix, 1)
    fun getZAxis(): Vector3f = axis(modelMatrix, 2)

    fun getWorldXAxis(): Vector3f = axis(getWorldModelMatrix(), 0)
    fun getWorldYAxis(): Vector3f = axis(getWorldModelMatrix(), 1)
    fun getWorldZAxis(): Vector3f = axis(getWorldModelMatrix(), 2)

    private fun axis(m: Matrix4f, column: Int): Vector3f = m.getColumn(column, Vector3f()).normalize()

    fun getWorldModelMatrix(): Matrix4f {
        val world = getLocalModelMatrix()
        var p = parent
        while (p != null) {
            world.mulLocal(p.getLocalModelMatrix())
            p = p.parent
        }
        return world
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
