package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.setAll
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    var color: Hsv,
    private val falloff: Vector3f = FALLOFF,
    private val cone: Cone = Cone.EVERYWHERE
) : Transformable(), IPointLight {

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) = shaderProgram.setAll(
        "$name.place" to viewMatrix.transformPosition(getWorldPosition()),
        "$name.axis" to viewMatrix.transformDirection(getWorldZAxis()),
        "$name.color" to color.toRgb(),
        "$name.falloff" to falloff,
        "$name.cone" to cone.asVector
    )

    companion object {
        val FALLOFF = Vector3f(1f, 0.5f, 0.1f)
    }
}
