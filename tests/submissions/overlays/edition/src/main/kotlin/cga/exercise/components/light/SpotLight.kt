package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight(
  position: Vector3f,
  color: Vector3f,
  private val innerCone: Float,
  private val outerCone: Float
) : PointLight(position, color, "spotLight"), ISpotLight {

  override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
    super.bind(shaderProgram)
    val direction = getWorldZAxis().negate().mul(Matrix3f(viewMatrix))
    shaderProgram.setUniform("spotLight.direction", direction)
    shaderProgram.setUniform("spotLight.cone", Vector2f(innerCone, outerCone))
  }
}
