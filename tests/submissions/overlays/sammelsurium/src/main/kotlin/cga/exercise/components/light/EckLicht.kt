package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** Punktlicht, das nicht am Motorrad haengt. nr = Platz im Array vom Shader */
class EckLicht(private val nr: Int, position: Vector3f, color: Vector3f) : PointLight(position, color) {

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("eckPos[" + nr + "]", getWorldPosition())
        shaderProgram.setUniform("eckColor[" + nr + "]", lightColor)
    }
}
