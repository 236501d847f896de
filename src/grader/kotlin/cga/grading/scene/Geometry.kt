package cga.grading.scene

import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import java.util.Locale
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cbrt
import kotlin.math.max

/** The rotation nearest to what [matrix] does to directions (polar decomposition); mirrored if [matrix] is. */
internal fun rotationPart(matrix: Matrix4dc): Matrix3d {
    val rotation = matrix.get3x3(Matrix3d())
    rotation.scale(1 / cbrt(abs(rotation.determinant())))
    // Newton's iteration doubles the correct digits each time once it is near; a stretch of 1000 to 1 takes 10 halvings to get there.
    repeat(POLAR_STEPS) { rotation.add(Matrix3d(rotation).invert().transpose()).scale(0.5) }
    return rotation
}

/** [matrix] without its scaling: rotation and translation. */
internal fun rigidPart(matrix: Matrix4dc): Matrix4d = Matrix4d().set(rotationPart(matrix)).setTranslation(matrix.translation())

internal fun Matrix4dc.translation(): Vector3d = getTranslation(Vector3d())

/** Whether every number is finite and space is not squashed flat. */
internal fun Matrix4dc.isUsable(): Boolean = isFinite && abs(determinant3x3()) > FLAT

/** The mean scale of lengths. */
internal fun Matrix4dc.scale(): Double = cbrt(abs(determinant3x3()))

/** How far [matrix] is from a rigid one: 0 is rigid; the largest relative change of a length. */
internal fun stretch(matrix: Matrix4dc): Double = max(abs(matrix.scale() - 1), unevenness(matrix))

/** How far [matrix] is from scaling all directions alike. */
internal fun unevenness(matrix: Matrix4dc): Double {
    val stretched = rotationPart(matrix).transpose().mul(matrix.get3x3(Matrix3d())).scale(1 / matrix.scale())
    return stretched.sub(Matrix3d()).get(DoubleArray(9)).maxOf { abs(it) }
}

/** sin of the angle times the axis, of a rotation. */
internal fun axial(rotation: Matrix3dc): Vector3d =
    Vector3d(
        rotation.m12() - rotation.m21(),
        rotation.m20() - rotation.m02(),
        rotation.m01() - rotation.m10(),
    ).mul(0.5)

/** The angle of a rotation, radians in [0, π]. */
internal fun angle(rotation: Matrix3dc): Double =
    atan2(axial(rotation).length(), (rotation.m00() + rotation.m11() + rotation.m22() - 1) / 2)

/** The angle between two directions, exact also where it is small. */
internal fun angle(a: Vector3dc, b: Vector3dc): Double = atan2(a.cross(b, Vector3d()).length(), a.dot(b))

internal fun Double.text(): String = if (isNaN()) "none" else "%.4g".format(Locale.ROOT, this)

/** As a percentage, of something between 0 and 1. */
internal fun Double.percent(): String = "%.1f %%".format(Locale.ROOT, 100 * this)

internal fun Vector3dc.text(): String = "(${rounded(x())}, ${rounded(y())}, ${rounded(z())})"

// A zero has no sign.
private fun rounded(number: Double) = "%.3f".format(Locale.ROOT, if (abs(number) < 5e-4) 0.0 else number)

private const val POLAR_STEPS = 24
private const val FLAT = 1e-9
