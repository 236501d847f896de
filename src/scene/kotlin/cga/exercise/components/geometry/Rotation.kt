package cga.exercise.components.geometry

import org.joml.Matrix4d
import kotlin.math.cos
import kotlin.math.sin

/**
 * Sets this to Rx([pitch])·Ry([yaw])·Rz([roll]) and returns it; radians, any finite angle.
 *
 * Sines and cosines are Kotlin's, right to an ulp of a double. JOML makes its cosine of the sine, √(1 − sin²): in floats 2e-4 off near
 * right angles, and of the wrong sign beyond 2³¹ turns.
 */
internal fun Matrix4d.rotationOf(
    pitch: Float,
    yaw: Float,
    roll: Float,
): Matrix4d {
    val sp = sin(pitch.toDouble())
    val cp = cos(pitch.toDouble())
    val sy = sin(yaw.toDouble())
    val cy = cos(yaw.toDouble())
    val sr = sin(roll.toDouble())
    val cr = cos(roll.toDouble())
    identity()
    // A row of the source is a column of the matrix: where the x, the y and the z axis go.
    m00(cy * cr).m01(sp * sy * cr + cp * sr).m02(sp * sr - cp * sy * cr)
    m10(-cy * sr).m11(cp * cr - sp * sy * sr).m12(cp * sy * sr + sp * cr)
    m20(sy).m21(-sp * cy).m22(cp * cy)
    return this
}
