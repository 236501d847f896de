package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.uniforms
import org.joml.Matrix4f
import org.joml.Vector3f

/** Shines along its negative z axis, [inner] and [outer] are half angles in radians. */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val inner: Float,
    private val outer: Float
) : PointLight(position, color, LightUniforms.HEADLIGHT, Attenuation.SPOT), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        bind(shaderProgram)
        shaderProgram.uniforms {
            "kegel.achse" set viewMatrix.transformDirection(getWorldZAxis().negate()).normalize()
            "kegel.innen" set inner
            "kegel.aussen" set outer
        }
    }
}
