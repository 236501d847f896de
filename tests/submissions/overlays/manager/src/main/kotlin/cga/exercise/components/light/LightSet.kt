package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** All lights of a scene. MAX_LIGHTS must be the same as in the shader. */
class LightSet(private val ambient: Vector3f) {
    private val pointLights = ArrayList<PointLight>()
    private val spotLights = ArrayList<SpotLight>()

    fun add(light: PointLight): LightSet {
        if (light is SpotLight) spotLights.add(light) else pointLights.add(light)
        check(pointLights.size <= MAX_LIGHTS && spotLights.size <= MAX_LIGHTS) { "too many lights" }
        return this
    }

    fun upload(shader: ShaderProgram) {
        shader.setVec3("u_AmbientLight", ambient)
        for (i in pointLights.indices) {
            pointLights[i].upload(shader, "u_PointLights[$i]")
        }
        shader.setInt("u_PointLightCount", pointLights.size)
        for (i in spotLights.indices) {
            spotLights[i].upload(shader, "u_SpotLights[$i]")
        }
        shader.setInt("u_SpotLightCount", spotLights.size)
    }

    companion object {
        const val MAX_LIGHTS = 8
    }
}
