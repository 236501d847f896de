package cga.grading.scene

import cga.grading.capture.Cursor
import cga.grading.capture.Key
import cga.grading.capture.Moment
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector4d
import java.lang.Math.IEEEremainder
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.asin
import kotlin.math.atan2
import kotlin.math.max
import kotlin.math.sin
import kotlin.math.tan

/**
 * What the mouse did before a moment.
 *
 * @param first whether it is the first that is heard of it: then [x] and [y] are pixels from the top left.
 * @param x pixels to the right, [y] pixels down.
 */
internal class MouseMove(
    val moment: Moment,
    val first: Boolean,
    val x: Double,
    val y: Double,
    val alt: Boolean,
) {
    companion object {
        /** From [Moment.MOUSE_FIRST] on as long as nothing is driven; a rest has x = y = 0. */
        val ALL: List<MouseMove> =
            buildList {
                var last: Cursor? = null
                for (moment in Moment.entries) {
                    val cursor = moment.mouse
                    if ((last == null && cursor == null) || Key.FORWARD in moment.keys) continue
                    val now = cursor ?: last ?: continue
                    add(MouseMove(moment, last == null, now.x - (last?.x ?: 0.0), now.y - (last?.y ?: 0.0), Key.LEFT_ALT in moment.keys))
                    last = now
                }
            }
    }
}

/** A move of the mouse, and what the camera made of it. */
internal class Reaction(
    val move: MouseMove,
    val turn: Turn,
)

/** How the camera moved about the motorcycle from one frame to the next; all in the motorcycle's space, world units. */
internal class Turn(
    private val before: Shot,
    private val after: Shot,
) {
    private val motion: Matrix4d = Matrix4d(after.cameraInMotorcycle).mul(Matrix4d(before.cameraInMotorcycle).invert())
    private val rotation: Matrix3d = motion.get3x3(Matrix3d())

    /** Radians. */
    val angle: Double = angle(rotation)

    /** How far the camera went around the motorcycle's own upright axis, wherever it looks; radians in [0, π]. */
    val around: Double = abs(IEEEremainder(bearing(after) - bearing(before), 2 * PI))

    /** By how much the camera rose or sank, relative to its distance from the motorcycle. */
    val rise: Double = abs(after.cameraInMotorcycle.m31() - before.cameraInMotorcycle.m31()) / max(before.distance, NEAR)

    /** Unit vector in world space, of either sign; meaningless without an angle. */
    val axis: Vector3d = before.motorcycleTurn.transform(axial(rotation).normalize())

    /** How far the camera went, relative to its distance from the motorcycle. */
    val moved: Double =
        after.cameraInMotorcycle.translation().distance(before.cameraInMotorcycle.translation()) / max(before.distance, NEAR)

    /** By how much the horizon tilted, radians. */
    val roll: Double = abs(roll(after) - roll(before))

    /** From the axis to the vertical, radians in [0, π/2]. */
    val tilt: Double = angle(axis, UP).let { minOf(it, PI - it) }

    /** From the axis to the camera's own upward axis, radians in [0, π/2]. */
    val fromOwnAxis: Double = angle(axis, ownAxis()).let { minOf(it, PI - it) }

    /** From the camera's own upward axis to the vertical, radians. */
    val cameraTilt: Double = angle(ownAxis(), UP)

    /** Whether the motorcycle itself was turned in the world. */
    val motorcycleTurned: Double = angle(Matrix3d(after.motorcycleTurn).mul(Matrix3d(before.motorcycleTurn).transpose()))

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

    /** The least displacement |(R − 1)c + t| of a point of [box], minimised along one coordinate after the other; convex, so it converges. */
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

    private fun ownAxis() = before.camera.getColumn(1, Vector4d()).let { Vector3d(it.x, it.y, it.z) }

    private companion object {
        val UP = Vector3d(0.0, 1.0, 0.0)
        const val NEAR = 1e-3
        const val TINY = 1e-18
        const val ROUNDS = 200

        fun bearing(shot: Shot) = atan2(shot.cameraInMotorcycle.m30(), shot.cameraInMotorcycle.m32())

        /** The camera's x axis over the horizon, radians. */
        fun roll(shot: Shot) = asin(shot.camera.m01().coerceIn(-1.0, 1.0))
    }
}
