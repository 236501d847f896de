package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
  var fieldOfView: Float = Math.toRadians(90f),
  var aspect: Float = 16f / 9f,
  var near: Float = 0.1f,
  var far: Float = 100f
) : Transformable(), ICamera {

  override fun getCalculateViewMatrix(): Matrix4f {
    val eye = getWorldPosition()
    return Matrix4f().setLookAt(eye, getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
  }

  override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().setPerspective(fieldOfView, aspect, near, far)

  override fun bind(shader: ShaderProgram) {
    shader.setUniform("projection_matrix", getCalculateProjectionMatrix(), false)
    shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
  }
}
