package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var parent: Transformable? = null) {

    // lokale Matrix (im System vom Parent)
    private val matrix = Matrix4f()

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        matrix.rotateX(pitch).rotateY(yaw).rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val dreh = Matrix4f()
        dreh.translate(altMidpoint)
        dreh.rotateX(pitch).rotateY(yaw).rotateZ(roll)
        dreh.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        // von links dran
        matrix.set(dreh.mul(matrix))
    }

    fun translateLocal(deltaPos: Vector3f) {
        matrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        matrix.translateLocal(deltaPos)
    }

    fun scaleLocal(scale: Vector3f) {
        matrix.scale(scale)
    }

    fun getPosition() = achse(matrix, 3)

    fun getWorldPosition() = achse(getWorldModelMatrix(), 3)

    fun getXAxis(): Vector3f = achse(matrix, 0).normalize()
    fun getYAxis(): Vector3f = achse(matrix, 1).normalize()
    fun getZAxis(): Vector3f = achse(matrix, 2).normalize()

    fun getWorldXAxis(): Vector3f = achse(getWorldModelMatrix(), 0).normalize()
    fun getWorldYAxis(): Vector3f = achse(getWorldModelMatrix(), 1).normalize()
    fun getWorldZAxis(): Vector3f = achse(getWorldModelMatrix(), 2).normalize()

    private fun achse(m: Matrix4f, spalte: Int): Vector3f = m.getColumn(spalte, Vector3f())

    fun getLocalModelMatrix() = Matrix4f(matrix)

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent ?: return getLocalModelMatrix()
        return p.getWorldModelMatrix().mul(matrix)
    }
}
