package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var parent: Transformable? = null) {

    // Model-Matrix, bezogen auf den Parent
    private var M = Matrix4f()

    // ---- lokal: von rechts ----

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        M.mul(Matrix4f().rotationXYZ(pitch, yaw, roll))
    }

    fun translateLocal(deltaPos: Vector3f) {
        M.mul(Matrix4f().translation(deltaPos))
    }

    fun scaleLocal(scale: Vector3f) {
        M.mul(Matrix4f().scaling(scale))
    }

    // ---- global: von links ----

    fun translateGlobal(deltaPos: Vector3f) {
        M = Matrix4f().translation(deltaPos).mul(M)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        M = Matrices.rotationUm(altMidpoint, pitch, yaw, roll).mul(M)
    }

    // ---- Matrizen ----

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(M)

    fun getWorldModelMatrix(): Matrix4f {
        val elter = parent
        if (elter == null) return getLocalModelMatrix()
        return elter.getWorldModelMatrix().mul(M)
    }

    // ---- Position und Achsen ----

    fun getPosition(): Vector3f = M.getTranslation(Vector3f())
    fun getXAxis(): Vector3f = spalte(M, 0)
    fun getYAxis(): Vector3f = spalte(M, 1)
    fun getZAxis(): Vector3f = spalte(M, 2)

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())
    fun getWorldXAxis(): Vector3f = spalte(getWorldModelMatrix(), 0)
    fun getWorldYAxis(): Vector3f = spalte(getWorldModelMatrix(), 1)
    fun getWorldZAxis(): Vector3f = spalte(getWorldModelMatrix(), 2)

    private fun spalte(m: Matrix4f, nr: Int): Vector3f {
        val achse = Vector3f()
        m.getColumn(nr, achse)
        return achse.normalize()
    }
}
