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
 * makes the other terms is replaced by black on the way to it ([HiddenTerms]). Factors, which no colour shows alone, come from
 * `factors.frag`, which is sent the same uniforms.
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
    private val hidden = HiddenTerms(look)
    private val factors = FactorProgram(vertexPath, constants)
    private val black = Texture2D(ImageData.ofColor(0f, 0f, 0f), false)

    /** Whether the last [use] chose `factors.frag`. */
    private var showsFactor = false

    override fun use() {
        val factor = look.view.factor
        showsFactor = factor != null
        if (factor == null) {
            super.use()
            if (hidden.isAnyTexture) black.bind(BLACK_UNIT)
        } else {
            factors.use()
            factors.setUniform("factor", factor)
            factors.setUniform("chosen", look.light)
        }
    }

    override fun setUniform(
        name: String,
        value: Int,
    ) {
        if (showsFactor) return factors.setUniform(name, value)
        traffic.sent(name)
        super.setUniform(name, if (hidden.isTexture(name)) BLACK_UNIT else value)
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
        super.setUniform(name, if (hidden.isColor(name)) BLACK else value)
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

    private fun toInt(value: Boolean) = if (value) 1 else 0

    private companion object {
        /** A unit that the material's textures leave free. */
        const val BLACK_UNIT = 3
        val BLACK: Vector3fc = Vector3f()
    }
}
