package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(
    color: Vector3f,
    pos: Vector3f,
    uniform: String,
    private val inner: Float,
    private val outer: Float
) : PointLight(color, pos, uniform), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        bind(shaderProgram)

        // the light looks to -z like the camera
        val dir = viewMatrix.transformDirection(getWorldZAxis().negate())
        shaderProgram.send(name("dir") to dir)

        // the shader only needs the cosines
        shaderProgram.send(name("cosInner") to cos(inner), name("cosOuter") to cos(outer))
    }
}
