package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(position: Vector3f,
                lightColor: Vector3f,
                private val innerCone: Float,
                private val outerCone: Float,
                name: String) : PointLight(position, lightColor, name), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        super.bind(shaderProgram)
        val direction = getWorldZAxis().negate()
        val viewDirection = viewMatrix.transformDirection(direction, Vector3f())
        shaderProgram.setUniform(name + "_direction", viewDirection)
        // Kosinus nur einmal hier und nicht in jedem Fragment
        shaderProgram.setUniform(name + "_inner", cos(innerCone))
        shaderProgram.setUniform(name + "_outer", cos(outerCone))
    }
}
