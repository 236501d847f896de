package cga.grading.scene

import org.joml.Vector3d

/** What a camera looks at that goes with the motorcycle and does not keep it in the middle. */
internal object Gaze {
    /** The look-at target in the world wherever the motorcycle is; null where there is none, or where the camera stays behind. */
    fun fixed(timeline: Timeline): Vector3d? {
        val shots = timeline.laterShots
        if (shots.isEmpty() || !follows(shots)) return null
        val place = fit(shots.map(::sight))?.point ?: return null
        return place.takeIf { shots.maxOf { sight(it).left(doubleArrayOf(place.x, place.y, place.z)) / it.distance } < HITS }
    }

    private fun follows(shots: List<Shot>): Boolean {
        val way = shots.maxOf { it.motorcycle.translation().distance(shots[0].motorcycle.translation()) }
        val (least, most) = shots.minOf { it.distance } to shots.maxOf { it.distance }
        return way > FAR * most && most - least < KEEPS * most
    }

    /** That a point is on the line of sight: without what lies along the line it is where the camera is. */
    private fun sight(shot: Shot): Equation {
        val along = shot.camera.transformDirection(Vector3d(0.0, 0.0, -1.0))
        val across = { v: Vector3d -> v.fma(-v.dot(along), along) }
        return Equation((0..2).map { across(Vector3d().setComponent(it, 1.0)) }, Vector3d(), across(shot.camera.translation()))
    }

    /** Relative to the camera's distance from the motorcycle; float matrices that follow it are off by 1e-4. */
    private const val HITS = 1e-3
    private const val KEEPS = 0.02
    private const val FAR = 0.1
}
