package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(
    color: Vector3f,
    position: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(color, position, "spot"), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        super.bind(shaderProgram)
        // cosines, so that the shader need not work them out for every fragment
        shaderProgram.setUniform("spot_cosInner", cos(innerAngle))
        shaderProgram.setUniform("spot_cosOuter", cos(outerAngle))

        val dir = Vector3f(0.0f, 0.0f, -1.0f)
        Matrix4f(viewMatrix).mul(getWorldModelMatrix()).transformDirection(dir)
        shaderProgram.setUniform("spot_dir", dir)
    }
}
