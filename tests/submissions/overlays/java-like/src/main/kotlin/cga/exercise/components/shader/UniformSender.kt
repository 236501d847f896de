package cga.exercise.components.shader

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import org.joml.Vector3f

/**
 * The only class that knows the names of the uniforms.
 */
class UniformSender {

    private val shaderProgram: ShaderProgram

    constructor(shaderProgram: ShaderProgram) {
        this.shaderProgram = shaderProgram
    }

    fun begin() {
        this.shaderProgram.use()
    }

    fun getShaderProgram(): ShaderProgram {
        return this.shaderProgram
    }

    fun sendCamera(camera: TronCamera) {
        this.shaderProgram.setUniform("viewMatrix", camera.getCalculateViewMatrix(), false)
        this.shaderProgram.setUniform("projectionMatrix", camera.getCalculateProjectionMatrix(), false)
        this.shaderProgram.setUniform("cameraPosition", camera.getEyePoint())
    }

    fun sendLight(index: Int, light: PointLight) {
        val suffix: String = indexOf(index)
        this.shaderProgram.setUniform("lightPosition" + suffix, light.getWorldPosition())
        this.shaderProgram.setUniform("lightColor" + suffix, light.getLightColor())
        this.shaderProgram.setUniform("lightAttenuation" + suffix, light.getAttenuation())
        if (light is SpotLight) {
            this.sendCone(light)
        }
    }

    private fun sendCone(light: SpotLight) {
        this.shaderProgram.setUniform("spotDirection", light.getWorldDirection())
        this.shaderProgram.setUniform("spotInnerAngle", light.getInnerAngle())
        this.shaderProgram.setUniform("spotOuterAngle", light.getOuterAngle())
    }

    fun sendAmbient(ambient: Vector3f) {
        this.shaderProgram.setUniform("ambientColor", ambient)
    }

    fun sendRenderable(renderable: Renderable, overlay: Vector3f) {
        this.shaderProgram.setUniform("modelMatrix", renderable.getWorldModelMatrix(), false)
        this.shaderProgram.setUniform("overlayColor", overlay)
    }

    companion object {
        const val UNIT_EMISSIVE: Int = 3
        const val UNIT_DIFFUSE: Int = 4
        const val UNIT_SPECULAR: Int = 5

        private fun indexOf(index: Int): String {
            return "[" + index + "]"
        }

        fun sendMaterial(shaderProgram: ShaderProgram, material: Material) {
            material.getEmissiveTexture().bind(UNIT_EMISSIVE)
            material.getDiffuseTexture().bind(UNIT_DIFFUSE)
            material.getSpecularTexture().bind(UNIT_SPECULAR)
            shaderProgram.setUniform("emissiveTexture", UNIT_EMISSIVE)
            shaderProgram.setUniform("diffuseTexture", UNIT_DIFFUSE)
            shaderProgram.setUniform("specularTexture", UNIT_SPECULAR)
            shaderProgram.setUniform("shininess", material.getShininess())
            shaderProgram.setUniform("textureRepeat", material.getTextureRepeat())
        }
    }
}
