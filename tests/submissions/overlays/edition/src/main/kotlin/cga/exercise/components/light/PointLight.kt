package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
  position: Vector3f,
  var color: Vector3f,
  protected val uniform: String
) : Transformable(), IPointLight {

  constructor(position: Vector3f, color: Vector3f, number: Int) : this(position, color, "pointLights[$number]")

  init {
    preTranslate(position)
  }

  override fun bind(shaderProgram: ShaderProgram) {
    shaderProgram.setUniform("$uniform.position", getWorldPosition())
    shaderProgram.setUniform("$uniform.color", color)
  }
}
