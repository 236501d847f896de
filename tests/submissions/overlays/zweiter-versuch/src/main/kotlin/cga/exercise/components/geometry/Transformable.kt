package cga.exercise.components.geometry

import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /** Returns copy of object model matrix */
    fun getModelMatrix(): Matrix4f = Matrix4f(modelMatrix)

    /** Returns multiplication of world and object model matrices */
    fun getWorldModelMatrix(): Matrix4f {
        val p = parent ?: return getModelMatrix()
        return p.getWorldModelMatrix().mul(modelMatrix)
    }

    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val tmp = Matrix4f()
        tmp.translate(altMidpoint)
        tmp.rotateXYZ(pitch, yaw, roll)
        tmp.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        tmp.mul(modelMatrix, modelMatrix)
    }

    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun preTranslate(deltaPos: Vector3f) {
        modelMatrix.translateLocal(deltaPos)
    }

    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f = modelMatrix.getColumn(3, Vector3f())

    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getColumn(3, Vector3f())

    fun getXAxis(): Vector3f = modelMatrix.getColumn(0, Vector3f()).normalize()

    fun getYAxis(): Vector3f = modelMatrix.getColumn(1, Vector3f()).normalize()

    fun getZAxis(): Vector3f = modelMatrix.getColumn(2, Vector3f()).normalize()

    fun getWorldXAxis(): Vector3f = getWorldModelMatrix().getColumn(0, Vector3f()).normalize()

    fun getWorldYAxis(): Vector3f = getWorldModelMatrix().getColumn(1, Vector3f()).normalize()

    fun getWorldZAxis(): Vector3f = getWorldModelMatrix().getColumn(2, Vector3f()).normalize()

    // ------------------------------------------------------------------
    // eigene Helfer, uebernommen aus dem letzten Jahr
    // ------------------------------------------------------------------

    fun haengeAn(eltern: Transformable) {
        parent = eltern
    }

    fun hebeAn(hoehe: Float) {
        preTranslate(Vector3f(0f, hoehe, 0f))
    }

    // nach vorne kippen, in Grad!
    fun neige(grad: Float) {
        rotate(Math.toRadians(-grad), 0f, 0f)
    }

    fun fahre(strecke: Float) {
        translate(Vector3f(0f, 0f, -strecke))
    }

    fun lenke(winkel: Float) {
        rotate(0f, winkel, 0f)
    }

    // um den Ursprung des Parents
    fun umkreise(winkel: Float) {
        rotateAroundPoint(0f, winkel, 0f, Vector3f(0f))
    }

    // wohin das Objekt in der Welt schaut
    fun blickrichtung(): Vector3f = getWorldZAxis().negate()

    // fun setPosition(x: Float, y: Float, z: Float) { modelMatrix.setTranslation(x, y, z) }
}
