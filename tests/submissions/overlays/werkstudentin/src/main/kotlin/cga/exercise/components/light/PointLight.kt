package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.times
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.struct
import org.joml.Vector3f

/** Sends itself as the struct [uniform]. 1/d² needs strong lights, so there is an [intensity] beside the [color]. */
open class PointLight(
    position: Vector3f,
    var color: Vector3f,
    private val intensity: Float,
    private val uniform: String
) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) = shaderProgram.struct(uniform) {
        "position" set getWorldPosition()
        "radiance" set color * intensity
    }
}
