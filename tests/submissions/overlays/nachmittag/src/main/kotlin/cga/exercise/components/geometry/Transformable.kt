package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(protected var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        modelMatrix.rotateX(pitch)
        modelMatrix.rotateY(yaw)
        modelMatrix.rotateZ(roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
        // read from the bottom to the top, like with glm
        val transform = Matrix4f()
        transform.translate(altMidpoint)
        transform.rotateXYZ(pitch, yaw, roll)
        transform.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)

        modelMatrix = transform.mul(modelMatrix)
    }

    fun translateLocal(deltaPos: Vector3f) {
        modelMatrix.translate(deltaPos)
    }

    fun translateGlobal(deltaPos: Vector3f) {
        val translation = Matrix4f().translate(deltaPos)
        modelMatrix = translation.mul(modelMatrix)
    }

    fun scaleLocal(scale: Vector3f) {
        modelMatrix.scale(scale)
    }

    fun getLocalModelMatrix(): Matrix4f {
        return Matrix4f(modelMatrix)
    }

    fun getWorldModelMatrix(): Matrix4f {
        val world = getLocalModelMatrix()
        var node = parent
        while (node != null) {
            world.mulLocal(node.modelMatrix)
            node = node.parent
        }
        return world
    }

    private fun positionOf(m: Matrix4f) = Vector3f(m.m30(), m.m31(), m.m32())

    fun getPosition(): Vector3f = positionOf(modelMatrix)
    fun getWorldPosition(): Vector3f = positionOf(getWorldModelMatrix())

    private fun xAxisOf(m: Matrix4f) = Vector3f(m.m00(), m.m01(), m.m02()).normalize()
    private fun yAxisOf(m: Matrix4f) = Vector3f(m.m10(), m.m11(), m.m12()).normalize()
    private fun zAxisOf(m: Matrix4f) = Vector3f(m.m20(), m.m21(), m.m22()).normalize()

    fun getXAxis(): Vector3f = xAxisOf(modelMatrix)
    fun getYAxis(): Vector3f = yAxisOf(modelMatrix)
    fun getZAxis(): Vector3f = zAxisOf(modelMatrix)

    fun getWorldXAxis(): Vector3f = xAxisOf(getWorldModelMatrix())
    fun getWorldYAxis(): Vector3f = yAxisOf(getWorldModelMatrix())
    fun getWorldZAxis(): Vector3f = zAxisOf(getWorldModelMatrix())
}
