// solution
package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    var lightColor: Vector3f,
    var attenuation: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Transformable(), IPointLight {
    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.position", getWorldPosition())
        shaderProgram.setUniform("$name.color", lightColor)
        shaderProgram.setUniform("$name.attenuation", attenuation)
    }
}
// end of solution
