package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch).rotateY(yaw).rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val m = Matrix4f()
            .translate(altMidpoint)
            .rotateX(pitch)
            .rotateY(yaw)
            .rotateZ(roll)
            .translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
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

    fun getXAxis(): Vector3f = axis(getLocalModelMatrix(), 0)
    fun getYAxis(): Vector3f = axis(getLocalModelMatrix(), 1)
    fun getZAxis(): Vector3f = axis(getLocalModelMatrix(), 2)

    fun getWorldXAxis(): Vector3f = axis(getWorldModelMatrix(), 0)
    fun getWorldYAxis(): Vector3f = axis(getWorldModelMatrix(), 1)
    fun getWorldZAxis(): Vector3f = axis(getWorldModelMatrix(), 2)

    private fun axis(m: Matrix4f, i: Int): Vector3f = m.getColumn(i, Vector3f()).normalize()

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent
        return if (p != null) p.getWorldModelMatrix().mul(modelMatrix) else getLocalModelMatrix()
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
