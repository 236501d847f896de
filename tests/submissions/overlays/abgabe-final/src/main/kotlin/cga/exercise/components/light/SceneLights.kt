package cga.exercise.components.light

import cga.exercise.components.camera.ICamera
import cga.exercise.components.shader.ShaderProgram

/**
 * All lights of the scene in one place, so Scene.render() stays short.
 */
class SceneLights {
    private val lights = ArrayList<PointLight>()

    fun add(light: PointLight) {
        lights.add(light)
    }

    fun bind(shader: ShaderProgram, camera: ICamera) {
        val points = lights.filter { it !is SpotLight }
        for (i in points.indices) {
            points[i].bind(shader, "pointLights[$i]")
        }
        shader.setUniform("pointLightCount", points.size)

        val spots = lights.filterIsInstance<SpotLight>()
        for (spot in spots) {
            spot.bind(shader, "spotLight", camera.getCalculateViewMatrix())
        }
    }
}
