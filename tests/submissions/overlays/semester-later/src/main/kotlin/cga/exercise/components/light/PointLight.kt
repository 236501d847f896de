package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(position: Vector3f, val color: Vector3f) : Transformable(), IPointLight {

    /** Name of the struct in the shader. It is set by the [LightManager]. */
    var uniformName: String = ""

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        val positionInView = viewMatrix.transformPosition(getWorldPosition())
        shaderProgram.setUniform("$uniformName.positionVS", positionInView)
        shaderProgram.setUniform("$uniformName.radiance", color)
    }
}
