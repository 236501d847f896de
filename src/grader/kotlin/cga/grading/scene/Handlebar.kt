package cga.grading.scene

import cga.grading.capture.Key
import cga.grading.capture.Moment
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc

/** A headlight that hangs on the handlebar, or on the fork: it turns aside while a key steers, and comes back to the middle after. */
internal object Handlebar {
    /** When [light] is turned aside, or on its way back; empty where it is fixed to the motorcycle, or astray. */
    fun aside(
        light: LightTrack,
        timeline: Timeline,
    ): Set<Moment> {
        val seen = timeline.laterShots.mapNotNull { shot -> ahead(light, shot)?.let { shot.moment to it } }.toMap()
        val before = seen.filterKeys { it < Moment.STEERED }.values.toList()
        if (before.size < 2) return emptySet()
        val middle = before.fold(Vector3d()) { sum, way -> sum.add(way) }.normalize()
        if (before.any { angle(it, middle) > STILL }) return emptySet()
        val turned = seen.mapValues { (_, way) -> angle(way, middle) }
        if ((turned[Moment.STEERED] ?: 0.0) <= STILL || !returns(turned)) return emptySet()
        val aside = turned.filterValues { it > STILL }
        return if (aside.all { (moment, angle) -> isNear(light, timeline, moment, angle) }) aside.keys else emptySet()
    }

    /** Where it points in the motorcycle's space, a unit vector; null where it has no direction. */
    private fun ahead(
        light: LightTrack,
        shot: Shot,
    ): Vector3d? {
        val direction = light.at(shot.moment)?.spot?.direction?.let { Vector3d(it) } ?: return null
        val way = Matrix3d(shot.viewTurn).mul(shot.motorcycleTurn).transpose().transform(direction)
        return if (way.isFinite && way.length() > NONE) way.normalize() else null
    }

    /** Whether [turned], radians, goes back to 0 all the time that no key steers: a direction in a wrong space goes where the mouse goes. */
    private fun returns(turned: Map<Moment, Double>): Boolean {
        val free = turned.filterKeys { it >= Moment.STEERED && Key.RIGHT !in it.keys }.values.toList()
        return free.size > 1 && free.zipWithNext().all { (a, b) -> b < a || b <= STILL }
    }

    /** Whether [light] is still about where it is when nobody steers: it hangs [angle] aside, at the end of a short lever. */
    private fun isNear(
        light: LightTrack,
        timeline: Timeline,
        moment: Moment,
        angle: Double,
    ): Boolean {
        val start = timeline.laterShots.first()
        val now = timeline.shot(moment) ?: return false
        val (at, rest) = listOf(now, start).map { place(light, it) ?: return false }
        return at.distance(rest) <= LEVER * angle
    }

    /** In the motorcycle's space, world units. */
    private fun place(
        light: LightTrack,
        shot: Shot,
    ): Vector3dc? = light.at(shot.moment)?.let { Matrix4d(shot.motorcycleFrame).invert().transformPosition(shot.world(it)) }

    /** Radians. */
    private const val STILL = 3e-3
    private const val NONE = 1e-6

    /** World units: the motorcycle is two to three long. */
    private const val LEVER = 1.5
}
