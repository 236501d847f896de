package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch).rotateY(yaw).rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        val drehung = Matrix4f()
        drehung.translate(altMidpoint)
        drehung.rotateX(pitch).rotateY(yaw).rotateZ(roll)
        drehung.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
        drehung.mul(modelMatrix, modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val verschiebung = Matrix4f().translation(deltaPos)
        verschiebung.mul(modelMatrix, modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getLocalModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }

    fun getWorldModelMatrix(): Matrix4f {
        val eltern = parent
        if (eltern != null) {
            return eltern.getWorldModelMatrix().mul(modelMatrix)
        }
        return Matrix4f(modelMatrix)
    }

    fun getPosition(): Vector3f = Vector3f(modelMatrix.m30(), modelMatrix.m31(), modelMatrix.m32())

    fun getWorldPosition(): Vector3f {
        val welt = getWorldModelMatrix()
        return Vector3f(welt.m30(), welt.m31(), welt.m32())
    }

    fun getXAxis(): Vector3f = Vector3f(modelMatrix.m00(), modelMatrix.m01(), modelMatrix.m02()).normalize()
    fun getYAxis(): Vector3f = Vector3f(modelMatrix.m10(), modelMatrix.m11(), modelMatrix.m12()).normalize()
    fun getZAxis(): Vector3f = Vector3f(modelMatrix.m20(), modelMatrix.m21(), modelMatrix.m22()).normalize()

    fun getWorldXAxis(): Vector3f {
        val welt = getWorldModelMatrix()
        return Vector3f(welt.m00(), welt.m01(), welt.m02()).normalize()
    }

    fun getWorldYAxis(): Vector3f {
        val welt = getWorldModelMatrix()
        return Vector3f(welt.m10(), welt.m11(), welt.m12()).normalize()
    }

    fun getWorldZAxis(): Vector3f {
        val welt = getWorldModelMatrix()
        return Vector3f(welt.m20(), welt.m21(), welt.m22()).normalize()
    }
}
