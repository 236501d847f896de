package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.uniforms
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    var color: Vector3f,
    private val names: LightUniforms,
    private val attenuation: Attenuation = Attenuation.POINT
) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) = shaderProgram.uniforms {
        names.position set getWorldPosition() // world space, der Shader rechnet in die Ansicht um
        names.color set color
        names.attenuation set attenuation.toVector()
    }
}
