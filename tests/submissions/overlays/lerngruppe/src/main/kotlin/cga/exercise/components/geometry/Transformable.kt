package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

/**
 * Merkregel aus der Lerngruppe:
 *   lokal  = von rechts dran:  M' = M * X
 *   global = von links dran:   M' = X * M
 */
open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        val rotation = Matrix4f().rotateX(pitch).rotateY(yaw).rotateZ(roll)
        fromRight(rotation)
    }

    // Formel 2.9 aus Kapitel 3: M' = T(p) * R * T(-p) * M
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val back = Matrix4f().translation(Vector3f(altMidpoint).negate())
        val rotation = Matrix4f().rotateX(pitch).rotateY(yaw).rotateZ(roll)
        val forth = Matrix4f().translation(altMidpoint)
        fromLeft(back)
        fromLeft(rotation)
        fromLeft(forth)
    }

    fun translateLocal(deltaPos: Vector3f) {
        fromRight(Matrix4f().translation(deltaPos))
    }

    fun translateGlobal(deltaPos: Vector3f) {
        fromLeft(Matrix4f().translation(deltaPos))
    }

    fun scaleLocal(scale: Vector3f) {
        fromRight(Matrix4f().scaling(scale))
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)

    // Formel 2.7 aus Kapitel 3: M_world = M_parent * M_local (rekursiv)
    fun getWorldModelMatrix(): Matrix4f {
        val p = parent ?: return getLocalModelMatrix()
        return p.getWorldModelMatrix().mul(modelMatrix)
    }

    fun getPosition(): Vector3f = column(modelMatrix, 3)

    fun getWorldPosition(): Vector3f = column(getWorldModelMatrix(), 3)

    fun getXAxis(): Vector3f = column(modelMatrix, 0).normalize()
    fun getYAxis(): Vector3f = column(modelMatrix, 1).normalize()
    fun getZAxis(): Vector3f = column(modelMatrix, 2).normalize()

    fun getWorldXAxis(): Vector3f = column(getWorldModelMatrix(), 0).normalize()
    fun getWorldYAxis(): Vector3f = column(getWorldModelMatrix(), 1).normalize()
    fun getWorldZAxis(): Vector3f = column(getWorldModelMatrix(), 2).normalize()

    private fun column(m: Matrix4f, i: Int) = m.getColumn(i, Vector3f())

    private fun fromRight(x: Matrix4f) {
        modelMatrix.mul(x)
    }

    private fun fromLeft(x: Matrix4f) {
        modelMatrix = x.mul(modelMatrix)
    }
}
