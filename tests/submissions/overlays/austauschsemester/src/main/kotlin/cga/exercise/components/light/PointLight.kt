package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import org.joml.Vector3f

// uniform: name in the shader with a %s for the field, for example "luces.%s[2]" -> luces.pos[2], luces.color[2]
open class PointLight(var color: Vector3f, pos: Vector3f, private val uniform: String) : Transformable(), IPointLight {

    init {
        preTranslate(pos)
    }

    protected fun name(field: String) = uniform.format(field)

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.send(name("pos") to getWorldPosition(), name("color") to color)
    }
}
