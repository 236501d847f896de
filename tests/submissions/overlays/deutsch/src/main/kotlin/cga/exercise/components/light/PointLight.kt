package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    protected val pos: Vector3f,
    var farbe: Vector3f,
    protected val att: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Transformable(), IPointLight {

    init {
        translateGlobal(pos)
    }

    // name ist der Index im Array
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("lichtPos[$name]", getWorldPosition())
        shaderProgram.setUniform("lichtFarbe[$name]", farbe)
        shaderProgram.setUniform("lichtAtt[$name]", att)
    }
}
