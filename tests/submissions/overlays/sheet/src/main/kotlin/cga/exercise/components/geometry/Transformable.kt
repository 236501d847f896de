package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var matrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    // dreht um die eigenen Achsen
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        matrix.rotateX(pitch).rotateY(yaw).rotateZ(roll)
    }

    // dreht um einen Punkt (im Koordinatensystem des Parents)
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val drehung = Matrix4f()
        drehung.translate(altMidpoint)
        drehung.rotateXYZ(pitch, yaw, roll)
        drehung.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        matrix = drehung.mul(matrix)
    }

    // verschiebt entlang der eigenen Achsen
    fun translateLocal(deltaPos: Vector3f) {
        matrix.translate(deltaPos)
    }

    // verschiebt entlang der Achsen des Parents
    fun translateGlobal(deltaPos: Vector3f) {
        val verschiebung = Matrix4f().translate(deltaPos)
        matrix = verschiebung.mul(matrix)
    }

    fun scaleLocal(scale: Vector3f) {
        matrix.scale(scale)
    }

    fun getPosition(): Vector3f = Vector3f(matrix.m30(), matrix.m31(), matrix.m32())

    fun getWorldPosition(): Vector3f {
        val welt = getWorldModelMatrix()
        return Vector3f(welt.m30(), welt.m31(), welt.m32())
    }

    fun getXAxis(): Vector3f = spalte(matrix, 0)

    fun getYAxis(): Vector3f = spalte(matrix, 1)

    fun getZAxis(): Vector3f = spalte(matrix, 2)

    fun getWorldXAxis(): Vector3f = spalte(getWorldModelMatrix(), 0)

    fun getWorldYAxis(): Vector3f = spalte(getWorldModelMatrix(), 1)

    fun getWorldZAxis(): Vector3f = spalte(getWorldModelMatrix(), 2)

    fun getWorldModelMatrix(): Matrix4f {
        val p = parent ?: return getLocalModelMatrix()
        return p.getWorldModelMatrix().mul(matrix)
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(matrix)

    private fun spalte(m: Matrix4f, nummer: Int): Vector3f {
        val achse = Vector3f()
        m.getColumn(nummer, achse)
        return achse.normalize()
    }
}
