package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f

/** The maps of a material, in the order of their texture units. */
enum class MapSlot(val sampler: String) {
    ALBEDO("albedoMap"),
    MIRROR("mirrorMap"),
    EMISSION("emissionMap")
}

class Material(
    diff: Texture2D,
    emit: Texture2D,
    specular: Texture2D,
    private val shininess: Float = 50f,
    private val tcMultiplier: Vector2f = Vector2f(1f)
) {
    private val maps = mapOf(MapSlot.ALBEDO to diff, MapSlot.MIRROR to specular, MapSlot.EMISSION to emit)

    fun bind(shaderProgram: ShaderProgram) {
        maps.forEach { (slot, texture) ->
            texture.bind(slot.ordinal)
            shaderProgram.setUniform(slot.sampler, slot.ordinal)
        }
        shaderProgram.setUniform("polish", shininess)
        shaderProgram.setUniform("uvScale", tcMultiplier)
    }
}
