package cga.inspect.tune

import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * The knobs of one light.
 *
 * @param setColor how its colour is changed; the motorcycle's own light has one that the scene sets anew in every frame.
 */
internal class LightKnobs(
    private val light: PointLight,
    private val setColor: (Vector3fc) -> Unit = { light.lightColor = it },
) {
    private val vector = Vector3f()
    private val angles = Vector2f()

    /** Colour, position, attenuation, and the cone where there is one. */
    fun groups(): List<KnobGroup> =
        listOfNotNull(
            KnobGroup("colour L", color()),
            KnobGroup("position, in the space of what it is fixed to", position()),
            KnobGroup(ATTENUATION, attenuation()),
            (light as? SpotLight)?.let { KnobGroup("cone, degrees from the axis", cone(it)) },
        )

    private fun color() = axes("red", "green", "blue", 0f, MAX_COLOR, { light.lightColor }, setColor)

    private fun position() =
        axes("x", "y", "z", -MAX_DISTANCE, MAX_DISTANCE, { light.getPosition() }) { place ->
            light.setLocalModelMatrix(light.getLocalModelMatrix().setTranslation(place))
        }

    // All three at 0 is no attenuation that a light can have: the light refuses it, and the knob stays where it is.
    private fun attenuation() =
        axes("K_c", "K_l", "K_q", 0f, MAX_ATTENUATION, { light.attenuation }) { k ->
            if (maxOf(k.x(), k.y(), k.z()) > 0f) light.attenuation = k
        }

    // The inner angle pushes the outer one before it, and the other way round.
    private fun cone(light: SpotLight) =
        listOf(
            Knob(
                "inner",
                0f,
                MAX_ANGLE,
                { degrees(light.getCone(angles).x) },
            ) { light.setCone(radians(it), maxOf(radians(it), light.getCone(angles).y)) },
            Knob(
                "outer",
                0f,
                MAX_ANGLE,
                { degrees(light.getCone(angles).y) },
            ) { light.setCone(minOf(radians(it), light.getCone(angles).x), radians(it)) },
        )

    private fun axes(
        x: String,
        y: String,
        z: String,
        min: Float,
        max: Float,
        get: () -> Vector3fc,
        set: (Vector3fc) -> Unit,
    ) = listOf(x, y, z).mapIndexed { i, name ->
        Knob(name, min, max, { get()[i] }) { value -> set(vector.set(get()).setComponent(i, value)) }
    }

    companion object {
        /** Title of the group with K. */
        const val ATTENUATION: String = "attenuation K"
        private const val MAX_COLOR = 20f
        private const val MAX_DISTANCE = 25f
        private const val MAX_ATTENUATION = 2f
        private const val MAX_ANGLE = 90f

        fun degrees(radians: Float): Float = Math.toDegrees(radians.toDouble()).toFloat()

        // The float nearest to 90° is a little more than π/2 of the light's own limit.
        fun radians(degrees: Float): Float = Math.toRadians(degrees.toDouble()).toFloat().coerceAtMost((Math.PI / 2).toFloat())
    }
}
