package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

interface Switchable {
    var on: Boolean
}

/** A directional light, and the light that comes from everywhere. */
class Sunlight(private val toSun: Vector3f, private val color: Vector3f) : Switchable {
    override var on = true

    fun bind(shader: ShaderProgram, view: Matrix4f) {
        shader.setUniform("uSun.on", on)
        shader.setUniform("uSun.toSun", view.transformDirection(Vector3f(toSun)))
        shader.setUniform("uSun.color", color)
    }
}

class Ambience(private val ambient: Vector3f, private val sky: Vector3f, private val soil: Vector3f) : Switchable {
    override var on = true

    fun bind(shader: ShaderProgram, view: Matrix4f) {
        val strength = if (on) 1.0f else 0.0f
        shader.setUniform("uAmbient", Vector3f(ambient).mul(strength))
        shader.setUniform("uSky", Vector3f(sky).mul(strength))
        shader.setUniform("uSoil", Vector3f(soil).mul(strength))
        shader.setUniform("uUp", view.transformDirection(Vector3f(0.0f, 1.0f, 0.0f)))
    }
}
