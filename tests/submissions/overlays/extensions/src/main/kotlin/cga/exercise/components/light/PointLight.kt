package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import org.joml.Vector2f
import org.joml.Vector3f

/** @param color of the light at a time (seconds) */
open class PointLight(position: Vector3f, private val color: (Float) -> Vector3f) : Transformable(), IPointLight {
    protected open val attenuation = Vector3f(1.0f, 0.5f, 0.1f)

    var now = 0.0f

    constructor(position: Vector3f, color: Vector3f) : this(position, { color })

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) = shaderProgram.send(
        "lightPos$name" to getWorldPosition(),
        "lightColor$name" to color(now),
        "lightK$name" to attenuation,
        // shines everywhere: 0 * cos + 1
        "lightAxis$name" to Vector3f(0.0f, 0.0f, 1.0f),
        "lightCone$name" to Vector2f(0.0f, 1.0f)
    )
}
