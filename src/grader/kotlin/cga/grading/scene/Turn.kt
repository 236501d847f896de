package cga.grading.scene

import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d
import java.lang.Math.IEEEremainder
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.asin
import kotlin.math.atan2
import kotlin.math.max
import kotlin.math.sin
import kotlin.math.tan

/**
 * How the camera moved from one frame to the next; all in the motorcycle's space, world units.
 *
 * @param pose where the camera is at the second shot, in the motorcycle's space of the first; by itself in that of the second.
 */
internal class Turn(
    private val before: Shot,
    private val after: Shot,
    pose: (before: Shot, at: Shot) -> Matrix4d = { _, at -> at.cameraInMotorcycle },
) {
    private val then = pose(before, before)
    private val now = pose(before, after)
    private val motion: Matrix4d = Matrix4d(now).mul(Matrix4d(then).invert())
    private val rotation: Matrix3d = motion.get3x3(Matrix3d())

    /** Radians. */
    val angle: Double = angle(rotation)

    /** Unit vector in world space, of either sign; meaningless without an angle. */
    val axis: Vector3d = before.motorcycleTurn.transform(axial(rotation).normalize())

    /** How far the camera went around the motorcycle's own upright axis, wherever it looks; radians in [−π, π]. */
    val around: Double = IEEEremainder(bearing(now) - bearing(then), 2 * PI)

    /** By how much the camera rose or sank, relative to its distance from the motorcycle. */
    val rise: Double = abs(now.m31() - then.m31()) / max(before.distance, NEAR)

    /** How far the camera went, relative to its distance from the motorcycle. */
    val moved: Double = now.translation().distance(then.translation()) / max(before.distance, NEAR)

    /** By how much the horizon tilted, radians. */
    val roll: Double = abs(roll(now) - roll(then))

    /** The x axis of [camera] over the horizon, radians. */
    private fun roll(camera: Matrix4d) = asin(before.motorcycleTurn.transform(camera.column(0)).y.coerceIn(-1.0, 1.0))

    /** From the axis to the vertical, radians in [0, π/2]. */
    val tilt: Double = angle(axis, UP).let { minOf(it, PI - it) }

    /** From the axis to the camera's own upward axis, radians in [0, π/2]. */
    val fromOwnAxis: Double = angle(axis, before.motorcycleTurn.transform(then.column(1))).let { minOf(it, PI - it) }

    /** Whether the motorcycle itself was turned in the world, radians. */
    val motorcycleTurned: Double = angle(Matrix3d(after.motorcycleTurn).mul(Matrix3d(before.motorcycleTurn).transpose()))

    /** The part of the turn about [reference], radians in [−π, π]. */
    fun about(reference: Vector3d): Double = if (angle < TINY) 0.0 else angle * axis.dot(reference)

    /**
     * How far the axis passes the motorcycle by, relative to the camera's distance: 0 through it, 1 through the camera. Anything inside
     * [box] is the motorcycle.
     */
    fun passesBy(box: Bounds): Double = displacement(box) / (2 * sin(angle / 2)) / max(before.distance, NEAR)

    /** Where the axis is: its point nearest to the motorcycle's origin, in world space. */
    fun pivot(): Vector3d {
        val axis = axial(rotation).normalize()
        val way = motion.translation()
        way.fma(-way.dot(axis), axis)
        val point = axis.cross(way, Vector3d()).div(tan(angle / 2)).add(way).mul(0.5)
        return before.motorcycleFrame.transformPosition(point)
    }

    /** The least displacement |(R − 1)c + t| of a point of [box], minimised along one coordinate after the other, which is convex. */
    private fun displacement(box: Bounds): Double {
        val matrix = Matrix3d(rotation).sub(Matrix3d())
        val point = Vector3d().max(box.least).min(box.most)
        val way = motion.translation()
        val left = Vector3d()
        repeat(ROUNDS) {
            for (i in 0..2) {
                val column = matrix.getColumn(i, Vector3d())
                if (column.lengthSquared() < TINY) continue
                matrix.transform(point, left).add(way)
                val best = point.get(i) - column.dot(left) / column.lengthSquared()
                point.setComponent(i, best.coerceIn(box.least.get(i), box.most.get(i)))
            }
        }
        return matrix.transform(point, left).add(way).length()
    }

    private companion object {
        val UP = Vector3d(0.0, 1.0, 0.0)
        const val NEAR = 1e-3
        const val TINY = 1e-18
        const val ROUNDS = 200

        fun bearing(camera: Matrix4d) = atan2(camera.m30(), camera.m32())
    }
}
