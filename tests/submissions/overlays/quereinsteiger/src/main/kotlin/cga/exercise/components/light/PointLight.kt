package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** Only data, see LightManager for the shader part. */
open class PointLight(position: Vector3f, val color: Vector3f) : Transformable(), IPointLight {

    /** constant, linear, quadratic */
    var falloff = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    // the interface wants it, but LightManager sends everything
    override fun bind(shaderProgram: ShaderProgram, name: String) {}
}
