package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Vector3d
import kotlin.math.max

/** Task 4.6: further point lights, of different colours and at different places. */
internal class MoreLightsJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val book: Notebook,
) {
    fun judge() {
        val further = roles.further
        val places = further.filter { light -> further.takeWhile { it !== light }.none { samePlace(it, light) } }
        val colors = further.filter { light -> further.takeWhile { it !== light }.none { sameColor(it, light) } }
        val counted = minOf(places.size, colors.size)
        val error = max(0.0, 1 - counted / WANTED)
        val text = "${further.size} further point lights at ${places.size} places, in ${colors.size} colours"
        val full = "$text; wanted: ${WANTED.toInt()} or more of each."
        if (further.isEmpty()) book.absent(Check.MORE_LIGHTS, full) else book.measured(Check.MORE_LIGHTS, error, full)
        if (error > 0 && places.size >= WANTED && further.all(::takesOwnColor)) {
            val names = further.joinToString { it.name }
            book.found(Mistake.LATER_LIGHTS_FIRST_COLOR, 0.0, error, names, explains = setOf(Check.MORE_LIGHTS))
        } else if (error > 0 && further.size >= WANTED) {
            book.found(Mistake.MORE_LIGHTS_ALIKE, 0.0, error, text)
        } else if (error > 0) {
            book.found(Mistake.MORE_LIGHTS_MISSING, 0.0, error, text)
            book.lacks("the further lights", setOf(Check.MORE_LIGHTS, Check.MORE_LIGHTS_SHADING), setOf(Mistake.MORE_LIGHTS_MISSING))
        }
    }

    /** Whether [light] follows the colour that the motorcycle's light has, which changes with time. */
    private fun takesOwnColor(light: LightTrack): Boolean {
        val own = roles.own?.takeIf { it.changesColor } ?: return false
        return timeline.laterShots.all { shot ->
            val a = own.at(shot.moment) ?: return@all true
            val b = light.at(shot.moment) ?: return@all true
            hue(a).distance(hue(b)) < DIFFERENT
        }
    }

    private fun samePlace(
        a: LightTrack,
        b: LightTrack,
    ): Boolean =
        timeline.laterShots.all { shot ->
            val p = a.at(shot.moment)?.position
            val q = b.at(shot.moment)?.position
            p == null || q == null || p.distance(q) < APART
        }

    /** Whether they differ in brightness only, or not even in that. */
    private fun sameColor(
        a: LightTrack,
        b: LightTrack,
    ): Boolean = hue(a.last).distance(hue(b.last)) < DIFFERENT

    private fun hue(light: ObservedLight) = Vector3d(light.color).div(max(light.color.maxAbs(), LightTrack.DARK))

    private companion object {
        const val WANTED = 2.0

        /** World units. */
        const val APART = 0.1
        const val DIFFERENT = 0.05
    }
}
