package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.direction
import cga.exercise.components.shader.send
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import kotlin.math.cos

/** @param inner and [outer] are radians. The light shines along -z. */
class SpotLight(position: Vector3f, color: Vector3f, private val inner: Float, private val outer: Float) :
    PointLight(position, color), ISpotLight {

    override val attenuation = Vector3f(0.5f, 0.05f, 0.01f)

    // I = (cos - cos(outer)) / (cos(inner) - cos(outer)) = slope * cos + offset
    private val slope = 1.0f / (cos(inner) - cos(outer))
    private val offset = -cos(outer) * slope

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        shaderProgram.send(
            "lightAxis$name" to (viewMatrix direction getWorldZAxis()),
            "lightCone$name" to Vector2f(slope, offset)
        )
    }
}
