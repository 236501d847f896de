package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import kotlin.math.abs

/** Do the lights keep their strength? A vector that is multiplied in place, at each picture again, grows without end or dies away. */
internal class DriftJudge(
    private val frames: List<ObservedFrame>,
    private val roles: LightRoles,
    private val book: Notebook,
) {
    fun judge() {
        // The motorcycle's light may change as it likes, and so for a while by a factor.
        val own = listOfNotNull(roles.own).filter { strengths(it).run { min() * FAR < max() } }.map { it to Check.POINT_LIGHT }
        val spot = listOfNotNull(roles.spot).map { it to Check.SPOT_LIGHT }
        val all = (own + spot + roles.further.map { it to Check.MORE_LIGHTS }).filter { (light, _) -> drifts(light) }
        if (all.isEmpty()) return
        val names = all.joinToString { (light, _) -> light.name }
        for (check in all.map { it.second }.distinct()) {
            book.spoilt(
                check,
                1.0,
                "From picture to picture the light of $names grows or dies away; wanted: light that keeps its strength.",
            )
        }
        book.found(Mistake.UNKNOWN, 1.0, 1.0, names)
    }

    /** Whether it is multiplied with the same share at each picture, however long after the one before. */
    private fun drifts(light: LightTrack): Boolean {
        val shares = strengths(light).zipWithNext { before, now -> now / before }
        return shares.size >= FEWEST && shares.all { abs(it - 1) > LEAST && abs(it / shares[0] - 1) < SAME_SHARE }
    }

    private fun strengths(light: LightTrack): List<Double> = frames.mapNotNull { light.at(it.moment)?.color?.maxAbs() }

    private companion object {
        const val FAR = 100
        const val FEWEST = 3
        const val LEAST = 0.01
        const val SAME_SHARE = 1e-3
    }
}
