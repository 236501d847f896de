package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

/** Something with a place in the scene graph: its matrix leads from its own space into that of its [parent]. */
open class Transformable(var parent: Transformable? = null) {

    private val matrix = Matrix4f()

    fun getModelMatrix(): Matrix4f = Matrix4f(matrix)

    fun getWorldModelMatrix(): Matrix4f = parent?.getWorldModelMatrix()?.mul(matrix) ?: getModelMatrix()

    fun translate(deltaPos: Vector3f) {
        matrix.translate(deltaPos)
    }

    fun preTranslate(deltaPos: Vector3f) {
        matrix.translateLocal(deltaPos)
    }

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        matrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val (x, y, z) = altMidpoint
        val turn = Matrix4f().translate(x, y, z).rotateXYZ(pitch, yaw, roll).translate(-x, -y, -z)
        matrix.mulLocal(turn)
    }

    fun scale(scale: Vector3f) {
        matrix.scale(scale)
    }

    fun getPosition(): Vector3f = matrix.position
    fun getXAxis(): Vector3f = matrix.axis(0)
    fun getYAxis(): Vector3f = matrix.axis(1)
    fun getZAxis(): Vector3f = matrix.axis(2)

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().position
    fun getWorldXAxis(): Vector3f = getWorldModelMatrix().axis(0)
    fun getWorldYAxis(): Vector3f = getWorldModelMatrix().axis(1)
    fun getWorldZAxis(): Vector3f = getWorldModelMatrix().axis(2)

    private val Matrix4f.position get() = getTranslation(Vector3f())
    private fun Matrix4f.axis(column: Int) = getColumn(column, Vector3f()).normalize()
}
