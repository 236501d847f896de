package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

class Material(
    private val diffuse: Texture2D,
    private val emission: Texture2D,
    private val specular: Texture2D,
    private val shininess: Float,
    private val repeat: Vector2f = Vector2f(1f, 1f)
) {
    fun bind(shader: ShaderProgram) {
        diffuse.bind(DIFFUSE_UNIT)
        shader.setInt("u_Material.diffuse", DIFFUSE_UNIT)
        specular.bind(SPECULAR_UNIT)
        shader.setInt("u_Material.specular", SPECULAR_UNIT)
        emission.bind(EMISSION_UNIT)
        shader.setInt("u_Material.emission", EMISSION_UNIT)
        shader.setFloat("u_Material.shininess", shininess)
        shader.setVec2("u_Repeat", repeat)
    }

    companion object {
        private const val DIFFUSE_UNIT = 0
        private const val SPECULAR_UNIT = 1
        private const val EMISSION_UNIT = 2
    }
}
