package cga.testing

import org.joml.Matrix3d
import org.joml.Matrix4f
import kotlin.math.cos
import kotlin.math.sin

/** A quarter turn in radians. Its float cosine is −4.4e-8 and not 0, less than a rounding of 1. */
const val QUARTER = (Math.PI / 2).toFloat()

/** The matrix whose rows are these, as one writes it on paper. */
fun rows(vararg elements: Number): Matrix4f = Matrix4f().set(FloatArray(16) { elements[it].toFloat() }).transpose()

/** Rx(pitch)·Ry(yaw)·Rz(roll), multiplied out by hand. */
fun turn(pitch: Double, yaw: Double, roll: Double): Matrix3d {
    val (sp, cp) = sin(pitch) to cos(pitch)
    val (sy, cy) = sin(yaw) to cos(yaw)
    val (sr, cr) = sin(roll) to cos(roll)
    return Matrix3d(
        cy * cr, cp * sr + sp * sy * cr, sp * sr - cp * sy * cr,
        -cy * sr, cp * cr - sp * sy * sr, sp * cr + cp * sy * sr,
        sy, -sp * cy, cp * cy,
    )
}

/** The same of floats, which are exact as doubles. */
fun turn(pitch: Float, yaw: Float, roll: Float): Matrix3d = turn(pitch.toDouble(), yaw.toDouble(), roll.toDouble())
