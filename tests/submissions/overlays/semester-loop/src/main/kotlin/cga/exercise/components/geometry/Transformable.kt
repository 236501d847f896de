package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var parent: Transformable? = null) {

    var modelMatrix = Matrix4f()
        protected set

    /**
     * Returns copy of object model matrix
     */
    fun getLocalMatrix() = Matrix4f(modelMatrix)

    /**
     * Returns multiplication of world and object model matrices.
     * Multiplication has to be recursive for all parents.
     */
    fun getWorldModelMatrix(): Matrix4f =
        if (parent == null) getLocalMatrix() else parent!!.getWorldModelMatrix().mul(modelMatrix)

    /**
     * Rotates object around its own origin.
     */
    fun rotate(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch).rotateY(yaw).rotateZ(roll)
    }

    /**
     * Rotates object around given rotation center (in the space of the parent).
     */
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        preTranslate(Vector3f(altMidpoint).negate())
        modelMatrix = Matrix4f().rotateXYZ(pitch, yaw, roll).mul(modelMatrix)
        preTranslate(altMidpoint)
    }

    /**
     * Translates object based on its own coordinate system.
     */
    fun translate(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    /**
     * Translates object based on its parent coordinate system.
     */
    fun preTranslate(deltaPos: Vector3f) {
        modelMatrix = Matrix4f().translation(deltaPos).mul(modelMatrix)
    }

    /**
     * Scales object related to its own origin
     */
    fun scale(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition() = Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())

    fun getWorldPosition(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m30(), m.m31(), m.m32())
    }

    fun getWorldXAxis(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m00(), m.m01(), m.m02()).normalize()
    }

    fun getWorldYAxis(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m10(), m.m11(), m.m12()).normalize()
    }

    fun getWorldZAxis(): Vector3f {
        val m = getWorldModelMatrix()
        return Vector3f(m.m20(), m.m21(), m.m22()).normalize()
    }
}
