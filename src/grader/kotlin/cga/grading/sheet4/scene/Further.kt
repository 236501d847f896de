package cga.grading.sheet4.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.LightTrack
import cga.grading.scene.ObservedLight
import cga.grading.scene.maxAbs
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.max

/** Task 4.6: further point lights, of different colours and at different places; and whether all lights keep their strength. */
internal class Further(private val staging: Staging) {
    private val timeline = staging.timeline
    private val roles = staging.roles

    fun axes(): List<Axis> = listOf(number()) + strength()

    private fun number(): Axis {
        val further = roles.further
        val places = further.filterIndexed { i, light -> further.take(i).none { isSamePlace(it, light) } }
        val colors = further.filterIndexed { i, light -> further.take(i).none { isSameHue(it.track.last, light.track.last) } }
        val error = max(0.0, 1 - minOf(places.size, colors.size) / WANTED)
        val figures = "${further.size} further point lights at ${places.size} places, in ${colors.size} colours"
        val text = say("further.figures", further.size, places.size, colors.size, WANTED)
        val missing = Axis.found(Mistake.MORE_LIGHTS_MISSING, figures, error)
        val lack = say("lack.further")
        return when {
            further.isEmpty() -> Axis.absent(CHECK, text, missing).lacking(lack, Check.MORE_LIGHTS_SHADING)
            error == 0.0 -> Axis.right(CHECK, 0.0, text)
            places.size >= WANTED && further.all(::takesOwnColor) -> {
                val names = further.joinToString { it.name }
                Axis.wrong(CHECK, error, text, Mistake.LATER_LIGHTS_FIRST_COLOR, names, explains = setOf(CHECK))
            }
            further.size >= WANTED -> Axis.wrong(CHECK, error, text, Mistake.MORE_LIGHTS_ALIKE, figures)
            else -> Axis.wrong(CHECK, error, text, Mistake.MORE_LIGHTS_MISSING, figures).lacking(lack, Check.MORE_LIGHTS_SHADING)
        }
    }

    /** Whether [light] follows the colour that the motorcycle's light has, which changes with time. */
    private fun takesOwnColor(light: PlacedLight): Boolean {
        val own = roles.own?.takeIf { it.track.changesColor } ?: return false
        return both(own, light).all { (a, b) -> isSameHue(a, b) }
    }

    private fun isSamePlace(
        a: PlacedLight,
        b: PlacedLight,
    ) = both(a, b).all { (one, other) -> one.position.distance(other.position) < APART }

    private fun both(
        a: PlacedLight,
        b: PlacedLight,
    ) = timeline.laterShots.mapNotNull { shot -> a.track.at(shot.moment)?.let { one -> b.track.at(shot.moment)?.let { one to it } } }

    private fun isSameHue(a: ObservedLight, b: ObservedLight) = hue(a).distance(hue(b)) < DIFFERENT

    private fun hue(light: ObservedLight) = Vector3d(light.color).div(max(light.color.maxAbs(), LightTrack.DARK))

    /** A vector that is multiplied in place, at each picture again, grows without end or dies away. */
    private fun strength(): List<Axis> {
        // The motorcycle's light may change as it likes, and so for a while by a factor.
        val own = listOfNotNull(roles.own).filter { light -> strengths(light).run { min() * FAR < max() } }
        val all = (own + listOfNotNull(roles.spot) + roles.further).filter(::drifts)
        val names = all.joinToString { it.name }
        return all.map(staging::presence).distinct().map { Axis.wrong(it, 1.0, say("light.drifts", names), Mistake.UNKNOWN, names) }
    }

    /** Whether it is multiplied with the same share at each picture, however long after the one before. */
    private fun drifts(light: PlacedLight): Boolean {
        val shares = strengths(light).zipWithNext { before, now -> now / before }
        return shares.size >= FEWEST && shares.all { abs(it - 1) > LEAST && abs(it / shares[0] - 1) < SAME_SHARE }
    }

    private fun strengths(light: PlacedLight): List<Double> = timeline.frames.mapNotNull { light.track.at(it.moment)?.color?.maxAbs() }

    private companion object {
        val CHECK = Check.MORE_LIGHTS
        const val WANTED = 2.0

        /** World units. */
        const val APART = 0.1
        const val DIFFERENT = 0.05
        const val FAR = 100
        const val FEWEST = 3
        const val LEAST = 0.01
        const val SAME_SHARE = 1e-3
    }
}
