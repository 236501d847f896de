package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

  /** what the emission is multiplied by */
  var emissionColor = Vector3f(1f)

  fun render(shaderProgram: ShaderProgram) {
    shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
    shaderProgram.setUniform("emission_color", emissionColor)
    meshes.forEach { it.render(shaderProgram) }
  }

  fun cleanup() = meshes.forEach { it.cleanup() }
}
