package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

open class Transformable(var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val hin = Matrix4f().translate(altMidpoint.x, altMidpoint.y, altMidpoint.z)
        val drehen = Matrix4f().rotateXYZ(pitch, yaw, roll)
        val zurueck = Matrix4f().translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        val alles = hin.mul(drehen).mul(zurueck)
        modelMatrix = alles.mul(modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val schieben = Matrix4f()
        schieben.translate(deltaPos)
        modelMatrix = schieben.mul(modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())

    fun getWorldPosition(): Vector3f {
        val welt = getWorldModelMatrix()
        return Vector3f(welt.m30(), welt.m31(), welt.m32())
    }

    // Spalten der Matrix = Achsen (siehe Uebung 3)
    fun getXAxis(): Vector3f = spalte(modelMatrix, 0)
    fun getYAxis(): Vector3f = spalte(modelMatrix, 1)
    fun getZAxis(): Vector3f = spalte(modelMatrix, 2)

    fun getWorldXAxis(): Vector3f = spalte(getWorldModelMatrix(), 0)
    fun getWorldYAxis(): Vector3f = spalte(getWorldModelMatrix(), 1)
    fun getWorldZAxis(): Vector3f = spalte(getWorldModelMatrix(), 2)

    private fun spalte(m: Matrix4f, nummer: Int): Vector3f {
        val s = Vector4f()
        m.getColumn(nummer, s)
        val achse = Vector3f(s.x, s.y, s.z)
        achse.normalize()
        return achse
    }

    /** where a point of this object is in the world */
    fun punktInDerWelt(punkt: Vector3f): Vector3f {
        val p = Vector4f(punkt.x, punkt.y, punkt.z, 1.0f)
        p.mul(getWorldModelMatrix())
        return Vector3f(p.x, p.y, p.z)
    }

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent
        if (p != null) {
            val elternMatrix = p.getWorldModelMatrix()
            return elternMatrix.mul(modelMatrix)
        } else {
            return Matrix4f(modelMatrix)
        }
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
