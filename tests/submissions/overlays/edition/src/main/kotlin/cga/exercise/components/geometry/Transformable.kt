package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

open class Transformable(private var modelMatrix: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

  fun getModelMatrix(): Matrix4f = Matrix4f(modelMatrix)

  fun getWorldModelMatrix(): Matrix4f {
    val p = parent ?: return getModelMatrix()
    return p.getWorldModelMatrix().mul(modelMatrix)
  }

  /** Rotates object around its own origin. */
  fun rotate(pitch: Float, yaw: Float, roll: Float) {
    modelMatrix.rotateXYZ(pitch, yaw, roll)
  }

  /** Rotates object around given rotation center. */
  fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) {
    val tmp = Matrix4f()
    tmp.translate(altMidpoint)
    tmp.rotateXYZ(pitch, yaw, roll)
    tmp.translate(-altMidpoint.x, -altMidpoint.y, -altMidpoint.z)
    modelMatrix = tmp.mul(modelMatrix)
  }

  /** Translates object based on its own coordinate system. */
  fun translate(deltaPos: Vector3f) {
    modelMatrix.translate(deltaPos)
  }

  /** Translates object based on its parent coordinate system. */
  fun preTranslate(deltaPos: Vector3f) {
    modelMatrix.translateLocal(deltaPos)
  }

  fun scale(scale: Vector3f) {
    modelMatrix.scale(scale)
  }

  fun getPosition(): Vector3f = modelMatrix.getTranslation(Vector3f())
  fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

  fun getXAxis(): Vector3f = axis(modelMatrix, 0)
  fun getYAxis(): Vector3f = axis(modelMatrix, 1)
  fun getZAxis(): Vector3f = axis(modelMatrix, 2)
  fun getWorldXAxis(): Vector3f = axis(getWorldModelMatrix(), 0)
  fun getWorldYAxis(): Vector3f = axis(getWorldModelMatrix(), 1)
  fun getWorldZAxis(): Vector3f = axis(getWorldModelMatrix(), 2)

  private fun axis(m: Matrix4f, column: Int) = m.getColumn(column, Vector3f()).normalize()
}
