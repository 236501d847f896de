package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/**
 * Knows all the lights and is the only one who sends them to the shader.
 * _MainLight...  the one below the rider
 * _HeadLight...  the spot
 * _AddLight...[] everything else
 */
class LightManager(private val mainLight: PointLight, private val headLight: SpotLight) {
    private val addLights = ArrayList<PointLight>()

    fun add(light: PointLight) {
        check(addLights.size < MAX_ADD_LIGHTS) { "too many lights, see MAX_ADD_LIGHTS in the shaders" }
        addLights += light
    }

    /** What never changes. Once is enough, but the shader has to be in use! */
    fun uploadStatic(shader: ShaderProgram) {
        shader.setUniform("_AddLightCount", addLights.size)
        for ((i, light) in addLights.withIndex()) {
            shader.setUniform("_AddLightColor[$i]", light.color)
            shader.setUniform("_AddLightFalloff[$i]", light.falloff)
        }
    }

    /** Every frame. Positions and directions are already in view space when they leave here. */
    fun upload(shader: ShaderProgram, view: Matrix4f) {
        shader.setUniform("_MainLightPos", toView(view, mainLight))
        shader.setUniform("_MainLightColor", mainLight.color)
        shader.setUniform("_MainLightFalloff", mainLight.falloff)

        shader.setUniform("_HeadLightPos", toView(view, headLight))
        shader.setUniform("_HeadLightDir", view.transformDirection(headLight.forward).normalize())
        shader.setUniform("_HeadLightColor", headLight.color)
        shader.setUniform("_HeadLightFalloff", headLight.falloff)
        shader.setUniform("_HeadLightCone", headLight.cone)

        for ((i, light) in addLights.withIndex()) {
            shader.setUniform("_AddLightPos[$i]", toView(view, light))
        }
    }

    private fun toView(view: Matrix4f, light: PointLight): Vector3f = view.transformPosition(light.position)

    companion object {
        const val MAX_ADD_LIGHTS = 6
    }
}
