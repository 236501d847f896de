package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /**
     * Rotates object around its own origin.
     */
    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateXYZ(pitch, yaw, roll)
    }

    /**
     * Rotates object around given rotation center.
     */
    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val tmp = Matrix4f()
        tmp.translate(altMidpoint)
        tmp.rotateXYZ(pitch, yaw, roll)
        tmp.translate(Vector3f(altMidpoint).negate())
        modelMatrix = tmp.mul(modelMatrix)
    }

    /**
     * Translates object based on its own coordinate system.
     */
    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    /**
     * Translates object based on its parent coordinate system.
     */
    fun translateGlobal(deltaPos: Vector3f) {
        val tmp = Matrix4f().translate(deltaPos)
        modelMatrix = tmp.mul(modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getPosition(): Vector3f {
        return Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())
    }

    fun getWorldPosition(): Vector3f {
        val world = getWorldModelMatrix()
        return Vector3f(world.m30(), world.m31(), world.m32())
    }

    fun getXAxis(): Vector3f = Vector3f(modelMatrix.m00(), modelMatrix.m01(), modelMatrix.m02()).normalize()

    fun getYAxis(): Vector3f = Vector3f(modelMatrix.m10(), modelMatrix.m11(), modelMatrix.m12()).normalize()

    fun getZAxis(): Vector3f = Vector3f(modelMatrix.m20(), modelMatrix.m21(), modelMatrix.m22()).normalize()

    fun getWorldXAxis(): Vector3f {
        val world = getWorldModelMatrix()
        return Vector3f(world.m00(), world.m01(), world.m02()).normalize()
    }

    fun getWorldYAxis(): Vector3f {
        val world = getWorldModelMatrix()
        return Vector3f(world.m10(), world.m11(), world.m12()).normalize()
    }

    fun getWorldZAxis(): Vector3f {
        val world = getWorldModelMatrix()
        return Vector3f(world.m20(), world.m21(), world.m22()).normalize()
    }

    fun getWorldModelMatrix(): Matrix4f {
        val world = getLocalModelMatrix()
        if (parent != null) {
            parent!!.getWorldModelMatrix().mul(world, world)
        }
        return world
    }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)
}
