package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

/** All lights of the scene. The first point light is the one of the bike. */
class LightRig {
    private val pointLights = ArrayList<PointLight>()
    private val spotLights = ArrayList<SpotLight>()

    fun add(light: PointLight) {
        if (light is SpotLight) spotLights.add(light) else pointLights.add(light)
    }

    fun bind(shader: ShaderProgram, viewMatrix: Matrix4f) {
        for (i in 0 until pointLights.size) {
            pointLights[i].bind(shader, "pointLights[$i]")
        }
        for (spot in spotLights) {
            spot.bind(shader, "headlight", viewMatrix)
        }
        shader.setUniform("numPointLights", pointLights.size)
    }
}
