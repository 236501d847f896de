package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake

/** Do the lights keep their strength? A vector that is multiplied in place, at each picture again, grows without end or dies away. */
internal class DriftJudge(
    private val frames: List<ObservedFrame>,
    private val roles: LightRoles,
    private val book: Notebook,
) {
    fun judge() {
        val own = listOfNotNull(roles.own).map { it to Check.POINT_LIGHT }
        val spot = listOfNotNull(roles.spot).map { it to Check.SPOT_LIGHT }
        val all = (own + spot + roles.further.map { it to Check.MORE_LIGHTS }).filter { (light, _) -> drifts(light.name) }
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

    private fun drifts(name: String): Boolean {
        val strengths = frames.mapNotNull { frame -> frame.lights.find { it.name == name }?.let(::strength) }.dropWhile { it == 0.0 }
        return grows(strengths) || grows(strengths.asReversed())
    }

    /** Step by step: what is switched on or off takes one. */
    private fun grows(strengths: List<Double>): Boolean =
        strengths.distinct().size >= STEPS && strengths.zipWithNext().all { (a, b) -> a <= b } && strengths.last() > FAR * strengths.first()

    /** What no float holds any more has grown beyond all. */
    private fun strength(light: ObservedLight): Double =
        if (light.color.isFinite) light.color.maxAbs() else Double.POSITIVE_INFINITY

    private companion object {
        const val STEPS = 3

        /** A light that is given a thousandth at one time and all of it at another would be seen as none. */
        const val FAR = 1e3
    }
}
