package cga.inspect.view

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.SpecularModel
import cga.framework.image.ImageData
import org.joml.Matrix3fc
import org.joml.Matrix4fc
import org.joml.Vector2fc
import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * The scene's program as [look] wants it. A term alone needs no second copy of the formula: the shader is the student's own, and what
 * makes the other terms is replaced by black on the way to it. Factors, which no colour shows alone, come from `factors.frag`, which is
 * sent the same uniforms.
 *
 * @param traffic is told what is sent, and what is said of uniforms that the shaders do not have.
 */
internal open class InspectedProgram(
    vertexPath: String,
    fragmentPath: String,
    constants: Map<String, Int>,
    private val look: Look,
    private val traffic: Traffic,
) : ShaderProgram(vertexPath, fragmentPath, constants) {
    private val pointLights = constants["POINT_LIGHTS"] ?: 0
    private val factors = FactorProgram(vertexPath, constants)
    private val black = Texture2D(ImageData.ofColor(0f, 0f, 0f), false)

    /** Whether the last [use] chose `factors.frag`. */
    private var showsFactor = false

    override fun use() {
        val factor = look.view.factor
        showsFactor = factor != null
        if (factor == null) {
            super.use()
            if (hidesTexture) black.bind(BLACK_UNIT)
        } else {
            factors.use()
            factors.setUniform("factor", factor)
            factors.setUniform("light", look.light)
        }
    }

    private val hidesTexture get() = look.view == View.DIFFUSE || look.view == View.SPECULAR

    override fun setUniform(
        name: String,
        value: Int,
    ) {
        if (showsFactor) return factors.setUniform(name, value)
        traffic.sent(name)
        val isHidden =
            when (name) {
                "material.diffuse" -> look.view == View.SPECULAR
                "material.specular" -> look.view == View.DIFFUSE
                else -> false
            }
        super.setUniform(name, if (isHidden) BLACK_UNIT else value)
    }

    override fun setUniform(
        name: String,
        value: Boolean,
    ) {
        val model = look.specularModel
        setUniform(name, if (name == "blinnPhong" && model != null) toInt(model == SpecularModel.BLINN_PHONG) else toInt(value))
    }

    override fun setUniform(
        name: String,
        value: Float,
    ) {
        if (showsFactor) return factors.setUniform(name, value)
        traffic.sent(name)
        super.setUniform(name, value)
    }

    override fun setUniform(
        name: String,
        value: Vector2fc,
    ) {
        if (showsFactor) return factors.setUniform(name, value)
        traffic.sent(name)
        super.setUniform(name, value)
    }

    override fun setUniform(
        name: String,
        value: Vector3fc,
    ) {
        if (showsFactor) return factors.setUniform(name, value)
        traffic.sent(name)
        super.setUniform(name, if (isHidden(name)) BLACK else value)
    }

    override fun setUniform(
        name: String,
        value: Matrix3fc,
        transpose: Boolean,
    ) {
        if (showsFactor) return factors.setUniform(name, value, transpose)
        traffic.sent(name)
        super.setUniform(name, value, transpose)
    }

    override fun setUniform(
        name: String,
        value: Matrix4fc,
        transpose: Boolean,
    ) {
        if (showsFactor) return factors.setUniform(name, value, transpose)
        traffic.sent(name)
        super.setUniform(name, value, transpose)
    }

    override fun reload() {
        super.reload()
        factors.reload()
    }

    override fun cleanup() {
        super.cleanup()
        factors.cleanup()
        black.cleanup()
    }

    override fun warn(message: String) {
        super.warn(message)
        traffic.warnings += message
    }

    private fun isHidden(name: String): Boolean {
        val view = look.view
        if (name == "emissiveTint") return view != View.FULL && view != View.EMISSION
        if (name == "ambient") return view != View.FULL && view != View.AMBIENT
        val light = light(name)
        return light != NO_LIGHT && (view == View.EMISSION || view == View.AMBIENT || !look.isOn(light))
    }

    /** The number of the light whose colour the uniform [name] is. */
    private fun light(name: String): Int {
        val isPoint = name.startsWith("pointLight[")
        if (!(isPoint || name.startsWith("spotLight[")) || !name.endsWith("].color")) return NO_LIGHT
        val first = if (isPoint) 0 else pointLights
        return (first + (name[name.indexOf('[') + 1] - '0')).coerceAtMost(Look.MAX_LIGHTS - 1)
    }

    private fun toInt(value: Boolean) = if (value) 1 else 0

    /** Compiled only when such a view is first asked for; a uniform that it lacks is the scene's business. */
    private class FactorProgram(
        vertexPath: String,
        constants: Map<String, Int>,
    ) : ShaderProgram(vertexPath, "shaders/inspect/factors.frag", constants) {
        private var isUsed = false

        override fun use() {
            isUsed = true
            super.use()
        }

        override fun reload() {
            if (isUsed) super.reload()
        }

        override fun warn(message: String) = Unit
    }

    private companion object {
        /** A unit that the material's textures leave free. */
        const val BLACK_UNIT = 3
        const val NO_LIGHT = -1
        val BLACK: Vector3fc = Vector3f()
    }
}
