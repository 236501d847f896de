package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.set
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    val color: Vector3f,
    private val falloff: Falloff = Falloff.POINT,
    private val cone: Cone = Cone.EVERYWHERE
) : Transformable(), IPointLight {

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram["$name.pos"] = worldPosition
        shaderProgram["$name.dir"] = worldForward // only matters for spots
        shaderProgram["$name.color"] = color
        shaderProgram["$name.k"] = falloff.packed
        shaderProgram["$name.cone"] = cone.packed
    }
}
