package cga.exercise.components.light

import cga.exercise.components.camera.ICamera
import cga.exercise.components.shader.ShaderProgram

/** Holds all lights of the scene and sends them as one array. */
class LightManager {
    private val lights = mutableListOf<PointLight>()

    operator fun <T : PointLight> plusAssign(light: T) {
        lights.add(light)
    }

    fun bindAll(shader: ShaderProgram, camera: ICamera) {
        val view = camera.getCalculateViewMatrix()
        lights.forEachIndexed { i, light ->
            when (light) {
                is SpotLight -> light.bind(shader, "u_lights[$i]", view)
                else -> light.bind(shader, "u_lights[$i]")
            }
        }
        shader.setUniform("u_lightCount", lights.size)
    }
}
