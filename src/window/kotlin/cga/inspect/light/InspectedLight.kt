package cga.inspect.light

import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.game.Scene
import cga.inspect.knob.Knob
import cga.inspect.knob.KnobGroup
import cga.inspect.knob.axes
import cga.inspect.knob.literal
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * A light as the window shows it: its sliders, its gizmo, its code. Of another kind of light this is the only file of the window that knows.
 *
 * @param setColor how its colour is changed.
 */
internal open class InspectedLight(
    open val light: PointLight,
    private val setColor: (Vector3fc) -> Unit = { light.lightColor = it },
) {
    /** What it is called; further ones of a kind have a number. */
    open val kind: String = "pointLight"

    private val position = Vector3d()

    /** Colour, position and attenuation. */
    open fun groups(): List<KnobGroup> =
        listOf(
            KnobGroup("colour L", axes("red", "green", "blue", 0f, MAX_COLOR, { light.lightColor }, setColor)),
            KnobGroup(
                "position, in the space of its parent",
                axes("x", "y", "z", -MAX_DISTANCE, MAX_DISTANCE, { light.getPosition() }, ::place),
            ),
            KnobGroup(ATTENUATION, axes("K_c", "K_l", "K_q", 0f, MAX_ATTENUATION, { light.attenuation }, ::attenuate)),
        )

    /** Adds its gizmo to [lines]. Allocates nothing. */
    open fun draw(lines: GizmoLines) {
        lines.color(light.lightColor)
        lines.marker(light.getWorldPosition(position))
    }

    /** Kotlin code that makes it. */
    open fun code(): String = "PointLight(${literal(light.getPosition())}, ${literal(light.lightColor)}, ${literal(light.attenuation)})"

    private fun place(position: Vector3fc) {
        light.setLocalModelMatrix(light.getLocalModelMatrix().setTranslation(position))
    }

    // The light refuses an attenuation of three zeros: then the knob stays where it is.
    private fun attenuate(k: Vector3fc) {
        if (maxOf(k.x(), k.y(), k.z()) > 0f) light.attenuation = k
    }

    companion object {
        /** Title of the group with K. */
        const val ATTENUATION: String = "attenuation K"
        private const val MAX_COLOR = 20f
        private const val MAX_DISTANCE = 25f
        private const val MAX_ATTENUATION = 2f

        /** [light] of [scene]. The motorcycle's point light has the motorcycle's colour: with one changes the other. */
        fun of(
            light: PointLight,
            scene: Scene,
        ): InspectedLight =
            when {
                light is SpotLight -> InspectedSpotLight(light)
                light.parent == null -> InspectedLight(light)
                else ->
                    InspectedLight(light) { color ->
                        light.lightColor = color
                        scene.motorcycleColor = Vector3f(color)
                    }
            }
    }
}

/** A spotlight: with its cone. */
private class InspectedSpotLight(override val light: SpotLight) : InspectedLight(light) {
    override val kind = "spotLight"
    private val position = Vector3d()
    private val direction = Vector3d()
    private val angles = Vector2f()

    override fun groups(): List<KnobGroup> = super.groups() + KnobGroup("cone, degrees from the axis", listOf(inner(), outer()))

    override fun draw(lines: GizmoLines) {
        super.draw(lines)
        light.getWorldPosition(position)
        light.getDirection(direction)
        light.getCone(angles)
        lines.cone(position, direction, angles.x.toDouble())
        lines.cone(position, direction, angles.y.toDouble())
    }

    override fun code(): String {
        val (inner, outer) = light.getCone(angles).run { x to y }
        val numbers =
            listOf(literal(light.getPosition()), literal(light.lightColor), literal(inner), literal(outer), literal(light.attenuation))
        return "SpotLight(${numbers.joinToString()}) // ${degrees(inner)}° and ${degrees(outer)}°"
    }

    // Each angle pushes the other before it.
    private fun inner() =
        Knob("inner", 0f, MAX_ANGLE, { degrees(light.getCone(angles).x) }) {
            light.setCone(radians(it), maxOf(radians(it), light.getCone(angles).y))
        }

    private fun outer() =
        Knob("outer", 0f, MAX_ANGLE, { degrees(light.getCone(angles).y) }) {
            light.setCone(minOf(radians(it), light.getCone(angles).x), radians(it))
        }

    private companion object {
        const val MAX_ANGLE = 90f

        fun degrees(radians: Float): Float = Math.toDegrees(radians.toDouble()).toFloat()

        // The float nearest to 90° is a little more than π/2, the light's own limit.
        fun radians(degrees: Float): Float = Math.toRadians(degrees.toDouble()).toFloat().coerceAtMost((Math.PI / 2).toFloat())
    }
}
