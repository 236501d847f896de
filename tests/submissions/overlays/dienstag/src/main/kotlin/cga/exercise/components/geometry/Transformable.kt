package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch)
        modelMatrix.rotateY(yaw)
        modelMatrix.rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val tmp = Matrix4f()
        tmp.translate(altMidpoint)
        tmp.rotateXYZ(pitch, yaw, roll)
        tmp.translate(Vector3f(altMidpoint).negate())
        modelMatrix = tmp.mul(modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val tmp = Matrix4f()
        tmp.translate(deltaPos)
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
        val p = parent
        if (p == null) {
            return getLocalModelMatrix()
        }
        return p.getWorldModelMatrix().mul(modelMatrix)
    }

    fun getLocalModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }
}
