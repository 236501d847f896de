package cga.grading.scene

import cga.grading.capture.Key
import cga.grading.capture.Moment
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d

/** A headlight on the handlebar, or on the fork: it turns aside while a key steers, and comes back to the middle after. */
internal object Handlebar {
    /** When [light] is turned aside, or on its way back; empty where it is fixed to the motorcycle, or astray. */
    fun aside(light: LightTrack, timeline: Timeline): Set<Moment> {
        val ways = timeline.laterShots.mapNotNull { shot -> ahead(light, shot)?.let { shot to it } }
        val before = ways.filter { (shot, _) -> shot.moment < Moment.STEERED }.map { it.second }
        if (before.size < 2) return emptySet()
        val middle = before.fold(Vector3d()) { sum, way -> sum.add(way) }.normalize()
        val turned = ways.associate { (shot, way) -> shot to angle(way, middle) }
        val aside = turned.filterValues { it > STILL }
        val isSteered = aside.keys.any { it.moment == Moment.STEERED } && aside.keys.all { it.moment >= Moment.STEERED }
        return if (isSteered && returns(turned) && aside.all { isNear(light, timeline, it) }) {
            aside.keys.map { it.moment }.toSet()
        } else {
            emptySet()
        }
    }

    /** Where it points in the motorcycle's space, a unit vector; null where it has no direction. */
    private fun ahead(light: LightTrack, shot: Shot): Vector3d? {
        val direction = light.at(shot.moment)?.spot?.direction ?: return null
        val way = Matrix3d(shot.viewTurn).mul(shot.motorcycleTurn).transpose().transform(Vector3d(direction))
        return if (way.isFinite && way.length() > NONE) way.normalize() else null
    }

    /** Whether it goes back all the time that no key steers: a direction in a wrong space goes where the mouse goes. */
    private fun returns(turned: Map<Shot, Double>): Boolean {
        val free = turned.filterKeys { it.moment >= Moment.STEERED && Key.RIGHT !in it.moment.keys }.values.toList()
        return free.size > 1 && free.zipWithNext().all { (a, b) -> b < a || b <= STILL }
    }

    /** Whether [light] is still about where it is when nobody steers: at the end of a short lever. */
    private fun isNear(light: LightTrack, timeline: Timeline, aside: Map.Entry<Shot, Double>): Boolean {
        val (now, rest) = listOf(aside.key, timeline.laterShots.first()).map { shot ->
            val state = light.at(shot.moment) ?: return false
            Matrix4d(shot.motorcycleFrame).invert().transformPosition(shot.world(state))
        }
        return now.distance(rest) <= LEVER * aside.value
    }

    /** Radians. */
    private const val STILL = 3e-3
    private const val NONE = 1e-6

    /** World units: the motorcycle is two to three long. */
    private const val LEVER = 1.5
}
