package cga.grading.scene

import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Vector3d
import kotlin.math.abs

/**
 * Do the lights keep their strength and their place? A vector that is multiplied in place, at each picture again, grows without end or dies
 * away; one that is added to wanders off.
 */
internal class DriftJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val book: Notebook,
) {
    fun judge() {
        strength()
        place()
    }

    private fun strength() {
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

    private fun place() {
        val own = listOfNotNull(roles.own).map { it to Check.POINT_LIGHT_POSITION }
        val spot = listOfNotNull(roles.spot).map { it to Check.SPOT_LIGHT_CHILD }
        val all = (own + spot + roles.further.map { it to Check.MORE_LIGHTS }).filter { (light, _) -> wandersOff(light) }
        if (all.isEmpty()) return
        val names = all.joinToString { (light, _) -> light.name }
        val text = "From picture to picture $names wanders off by as much; wanted: a place that only time and the motorcycle change."
        // They are all moved in the same way: that costs once.
        book.spoilt(all.first().second, 1.0, text)
        book.found(Mistake.UNKNOWN, 1.0, 1.0, names)
    }

    /** Whether it goes on by the same way at each picture, however long after the one before, while the motorcycle stands. */
    private fun wandersOff(light: LightTrack): Boolean {
        val standing = timeline.shots.filter { it.moment <= Moment.TIME_4 }
        val places = standing.mapNotNull { shot -> light.at(shot.moment)?.let(shot::world) }
        val steps = places.zipWithNext { before, now -> now.sub(before, Vector3d()) }
        val pauses = standing.zipWithNext { before, now -> now.frame.time - before.frame.time }
        val isSameTime = pauses.isEmpty() || pauses.max() < LONGER * pauses.min()
        return steps.size >= FEWEST && steps.size == pauses.size && !isSameTime &&
            steps[0].length() > WAY && steps.all { it.distance(steps[0]) < SAME_STEP * steps[0].length() }
    }

    /** Whether it is multiplied with the same share at each picture, however long after the one before. */
    private fun drifts(light: LightTrack): Boolean {
        val shares = strengths(light).zipWithNext { before, now -> now / before }
        return shares.size >= FEWEST && shares.all { abs(it - 1) > LEAST && abs(it / shares[0] - 1) < SAME_SHARE }
    }

    private fun strengths(light: LightTrack): List<Double> = timeline.frames.mapNotNull { light.at(it.moment)?.color?.maxAbs() }

    private companion object {
        const val FAR = 100
        const val FEWEST = 3
        const val LEAST = 0.01
        const val SAME_SHARE = 1e-3
        const val SAME_STEP = 2e-3
        const val LONGER = 1.5

        /** World units: at 60 pictures a second faster than anybody lets a light fly; what is added by mistake is a whole place. */
        const val WAY = 0.3
    }
}
