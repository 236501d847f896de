package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private val modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /** Drehung um die eigenen Achsen [rad] */
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    /** Drehung um einen Punkt [rad]; der Punkt ist in Koordinaten des Parents angegeben */
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val m = Matrix4f()
        m.translate(altMidpoint.x, altMidpoint.y, altMidpoint.z)
        m.rotateXYZ(pitch, yaw, roll)
        m.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        m.mul(modelMatrix, modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val m = Matrix4f().translation(deltaPos)
        m.mul(modelMatrix, modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)

    /** bewusst als Schleife und nicht rekursiv */
    fun getWorldModelMatrix(): Matrix4f {
        val world = Matrix4f(modelMatrix)
        var p: Transformable? = parent
        while (p != null) {
            p.modelMatrix.mul(world, world)
            p = p.parent
        }
        return world
    }

    fun getPosition(): Vector3f = Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())
    fun getWorldPosition(): Vector3f = spalte(getWorldModelMatrix(), 3)

    fun getXAxis(): Vector3f = spalte(modelMatrix, 0).normalize()
    fun getYAxis(): Vector3f = spalte(modelMatrix, 1).normalize()
    fun getZAxis(): Vector3f = spalte(modelMatrix, 2).normalize()

    fun getWorldXAxis(): Vector3f = spalte(getWorldModelMatrix(), 0).normalize()
    fun getWorldYAxis(): Vector3f = spalte(getWorldModelMatrix(), 1).normalize()
    fun getWorldZAxis(): Vector3f = spalte(getWorldModelMatrix(), 2).normalize()

    private fun spalte(m: Matrix4f, i: Int): Vector3f = m.getColumn(i, Vector3f())
}
