package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

/** Owns all lights of the scene and passes them to the shader. */
class LightManager {

    private val pointLights: MutableList<PointLight> = ArrayList()
    private var headlight: SpotLight? = null

    /** The position in the list is the index in the shader. */
    fun addPointLight(light: PointLight) {
        if (pointLights.size >= MAX_POINT_LIGHTS) {
            throw IllegalStateException("The shader only has room for $MAX_POINT_LIGHTS point lights")
        }
        light.uniformName = "lamps[" + pointLights.size + "]"
        pointLights.add(light)
    }

    fun setHeadlight(light: SpotLight) {
        light.uniformName = "headlamp"
        headlight = light
    }

    /** Has to be called after the shader is in use and before anything is drawn. */
    fun bindAll(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        shaderProgram.setUniform("lampCount", pointLights.size)
        for (light in pointLights) {
            light.bind(shaderProgram, viewMatrix)
        }
        headlight?.bind(shaderProgram, viewMatrix)
    }

    companion object {
        /** the same as MAX_LAMPS in the fragment shader */
        const val MAX_POINT_LIGHTS = 12
    }
}
