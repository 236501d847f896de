package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

/**
 * Vorlesung "Szenengraph": M_world = M_parent * M_local
 */
open class Transformable(protected var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    // M' = M * R
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    // M' = T(m) * R * T(-m) * M
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val t = Matrix4f().translation(altMidpoint)
        val r = Matrix4f().rotateXYZ(pitch, yaw, roll)
        val tInv = Matrix4f().translation(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        modelMatrix = t.mul(r).mul(tInv).mul(modelMatrix)
    }

    // M' = M * T
    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    // M' = T * M
    fun translateGlobal(deltaPos: Vector3f) {
        modelMatrix.translateLocal(deltaPos)
    }

    // M' = M * S
    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = spalte(modelMatrix, 3)

    fun getWorldPosition(): Vector3f = spalte(getWorldModelMatrix(), 3)

    fun getXAxis(): Vector3f = spalte(modelMatrix, 0).normalize()

    fun getYAxis(): Vector3f = spalte(modelMatrix, 1).normalize()

    fun getZAxis(): Vector3f = spalte(modelMatrix, 2).normalize()

    fun getWorldXAxis(): Vector3f = spalte(getWorldModelMatrix(), 0).normalize()

    fun getWorldYAxis(): Vector3f = spalte(getWorldModelMatrix(), 1).normalize()

    fun getWorldZAxis(): Vector3f = spalte(getWorldModelMatrix(), 2).normalize()

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent ?: return getLocalModelMatrix()
        return p.getWorldModelMatrix().mul(modelMatrix)
    }

    private fun spalte(m: Matrix4f, i: Int): Vector3f = m.getColumn(i, Vector3f())
}
