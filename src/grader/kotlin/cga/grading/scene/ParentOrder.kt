package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Are the matrices of parent and child multiplied in the wrong order? Then what hangs on the motorcycle is at L·P in the world and not at
 * P·L, where L is its own matrix and P the motorcycle's: it is moved with it, and turned about the middle of the world.
 */
internal class ParentOrder(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val book: Notebook,
) {
    /** Says so once, in the place of all that follows from it. */
    fun judge() {
        val spot = roles.spot?.takeIf(::isSwapped)
        val isCamera = isCameraSwapped()
        if (spot == null && !isCamera) return
        TRACES.forEach(book::remove)
        val home = if (spot == null) Check.ORBIT_PIVOT else Check.SPOT_LIGHT_CHILD
        val names = listOfNotNull(spot?.name, "camera".takeIf { isCamera }).joinToString()
        book.measured(
            home,
            1.0,
            "Turned about the middle of the world as the motorcycle drives: $names; wanted: parent · child, not child · parent.",
        )
        book.found(Mistake.UNKNOWN, 0.0, 1.0, names, explains = DISTURBED - home)
    }

    /** Whether the camera is so, before the mouse has moved. */
    private fun isCameraSwapped(): Boolean {
        val shots = timeline.laterShots.filter { it.moment.mouse == null && it.moment < MouseMove.ALL.first().moment }
        if (!turns(shots)) return false
        val right = shots.map { it.cameraInMotorcycle }
        val swapped = shots.map { Matrix4d(it.camera).mul(Matrix4d(it.motorcycleFrame).invert()) }
        return !areAlike(right) && areAlike(swapped)
    }

    /** Whether [spot] is so, by its places and its directions. */
    private fun isSwapped(spot: LightTrack): Boolean {
        val shots = timeline.laterShots.filter { spot.at(it.moment)?.spot?.direction?.isFinite == true }
        if (!turns(shots) || spot.placed.place?.right == true) return false
        return listOf(1.0, -1.0).any { sign -> explains(spot, shots, sign) }
    }

    private fun explains(
        spot: LightTrack,
        shots: List<Shot>,
        sign: Double,
    ): Boolean {
        val sent = shots.map { aim(spot, it) ?: return false }
        val ridden = shots.map { it.motorcycleTurn.transform(Vector3d(0.0, 0.0, -sign)) }
        val other = shots.indices.maxBy { angle(ridden[0], ridden[it]) }
        val turn = triad(sent[0], sent[other]).mul(triad(ridden[0], ridden[other]).transpose())
        val offsets = shots.map { shot ->
            val place = spot.at(shot.moment)?.let(shot::world) ?: return false
            place.sub(turn.transform(shot.motorcycle.translation()))
        }
        val isAimed = shots.indices.all { angle(turn.transform(Vector3d(ridden[it])), sent[it]) < HOLDS }
        return isAimed && shots.indices.all { offsets[it].distance(offsets[0]) < HOLDS * (1 + shots[it].distance) }
    }

    private fun aim(
        spot: LightTrack,
        shot: Shot,
    ): Vector3d? =
        spot.at(shot.moment)?.spot?.direction?.let { Matrix3d(shot.viewTurn).transpose().transform(Vector3d(it)).normalize() }

    /** Three directions at right angles, told from two. */
    private fun triad(
        a: Vector3dc,
        b: Vector3dc,
    ): Matrix3d {
        val first = Vector3d(a).normalize()
        val second = a.cross(b, Vector3d()).normalize()
        return Matrix3d(first, second, first.cross(second, Vector3d()))
    }

    private fun turns(shots: List<Shot>): Boolean =
        shots.size > 2 && shots.any { angle(Matrix3d(it.motorcycleTurn).mul(Matrix3d(shots[0].motorcycleTurn).transpose())) > TURNED }

    private fun areAlike(frames: List<Matrix4d>): Boolean =
        frames.all { it.equals(frames[0], HOLDS * (1 + frames[0].translation().length())) }

    private companion object {
        val TRACES =
            listOf(
                Mistake.LIGHT_NOT_CHILD, Mistake.SPOT_NOT_CHILD, Mistake.SPOT_DIRECTION_LOCAL, Mistake.SPOT_DIRECTION_WORLD,
                Mistake.ORBIT_PIVOT, Mistake.ORBIT_OWN_AXIS,
            )
        val DISTURBED =
            OrbitChecks.ALL +
                setOf(Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION)

        /** Radians, and relative to distances. */
        const val HOLDS = 3e-3
        const val TURNED = 0.1
    }
}
