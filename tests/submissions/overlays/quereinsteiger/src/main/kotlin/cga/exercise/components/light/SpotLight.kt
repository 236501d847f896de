package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.cos
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/** Both angles in radians and from the axis to the edge (Unity's spotAngle is the full cone!). */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, color), ISpotLight {

    /** the shader only ever needs the cosines */
    val cone: Vector2f
        get() = Vector2f(cos(innerAngle), cos(outerAngle))

    init {
        falloff = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {}
}
