package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import kotlin.math.cos

/** The spot light takes the last slot; the angles are radians. */
class SpotLight(position: Vector3f, color: Vector3f, slot: Int, private val inner: Float, private val outer: Float) :
    PointLight(position, color, slot), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        bind(shaderProgram)
        val direction = viewMatrix.transformDirection(getWorldZAxis().negate())
        shaderProgram.setUniform("spotDir", direction)
        shaderProgram.setUniform("spotCos", Vector2f(cos(inner), cos(outer)))
    }
}
