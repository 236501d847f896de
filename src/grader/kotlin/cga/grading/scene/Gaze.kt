package cga.grading.scene

import org.joml.Matrix3d
import org.joml.Vector3d

/** What a camera looks at that goes with the motorcycle and does not keep it in the middle. */
internal object Gaze {
    /** The place in the world that it looks at wherever the motorcycle is; null where there is none, or where the camera stays behind. */
    fun fixed(timeline: Timeline): Vector3d? {
        val shots = timeline.laterShots
        if (shots.isEmpty() || !follows(shots)) return null
        val place = nearest(shots) ?: return null
        val error = shots.maxOf { distance(it, place) / it.distance }
        return place.takeIf { error < HITS }
    }

    private fun follows(shots: List<Shot>): Boolean {
        val start = shots.first().motorcycle.translation()
        val way = shots.maxOf { it.motorcycle.translation().distance(start) }
        val (least, most) = shots.minOf { it.distance } to shots.maxOf { it.distance }
        return way > FAR * most && most - least < KEEPS * most
    }

    /** The point nearest to all lines of sight; null where they are parallel. */
    private fun nearest(shots: List<Shot>): Vector3d? {
        val sum = Matrix3d().zero()
        val right = Vector3d()
        for (shot in shots) {
            val across = across(shot)
            sum.add(across)
            right.add(across.transform(shot.camera.translation()))
        }
        return if (sum.determinant() < PARALLEL * shots.size) null else sum.invert().transform(right)
    }

    /** Takes from a vector what lies along the line of sight. */
    private fun across(shot: Shot): Matrix3d {
        val sight = shot.camera.transformDirection(Vector3d(0.0, 0.0, -1.0))
        return with(sight) {
            Matrix3d(1 - x * x, -x * y, -x * z, -x * y, 1 - y * y, -y * z, -x * z, -y * z, 1 - z * z)
        }
    }

    private fun distance(
        shot: Shot,
        place: Vector3d,
    ): Double = across(shot).transform(place.sub(shot.camera.translation(), Vector3d())).length()

    /** Relative to the camera's distance from the motorcycle; float matrices that follow it are off by 1e-4. */
    private const val HITS = 1e-3
    private const val KEEPS = 0.02
    private const val FAR = 0.1

    /** Of the squares of the sines between lines of sight. */
    private const val PARALLEL = 1e-6
}
