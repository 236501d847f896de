package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.FrameMaterial
import org.joml.Vector2f

/**
 * What a surface looks like: M_d, M_e, M_s and k of the lighting model.
 *
 * @param diff diffuse colours M_d.
 * @param emit emissive colours M_e.
 * @param specular specular colours M_s.
 * @param shininess exponent k, finite and ≥ 0, else [IllegalArgumentException].
 * @param tcMultiplier how often the textures repeat: factor of the texture coordinates.
 */
public class Material(
    public val diff: Texture2D,
    public val emit: Texture2D,
    public val specular: Texture2D,
    shininess: Float = 50f,
    public val tcMultiplier: Vector2f = Vector2f(1f),
) {
    public var shininess: Float = checked(shininess)
        set(value) {
            field = checked(value)
        }

    /** Sends the material to the program in use, the textures through units 0 to 2. */
    public fun bind(shaderProgram: ShaderProgram) {
        diff.bind(0)
        shaderProgram.setUniform("material.diffuse", 0)
        emit.bind(1)
        shaderProgram.setUniform("material.emissive", 1)
        specular.bind(2)
        shaderProgram.setUniform("material.specular", 2)
        shaderProgram.setUniform("material.shininess", shininess)
        shaderProgram.setUniform("tcMultiplier", tcMultiplier)
    }

    /** The material as plain data. */
    public fun toFrameMaterial(): FrameMaterial =
        FrameMaterial(emit.toFrameTexture(), diff.toFrameTexture(), specular.toFrameTexture(), shininess, Vector2f(tcMultiplier))

    /** Frees the textures. */
    public fun cleanup() {
        diff.cleanup()
        emit.cleanup()
        specular.cleanup()
    }

    private fun checked(k: Float): Float {
        require(k.isFinite() && k >= 0f) { "shininess $k: the specular exponent must be finite and at least 0" }
        return k
    }
}
