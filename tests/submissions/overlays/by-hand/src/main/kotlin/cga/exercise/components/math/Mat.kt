package cga.exercise.components.math

import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.PI
import kotlin.math.sqrt
import kotlin.math.tan

// 4x4 matrices, row by row: element (row, column) is m[4 * row + column].
// OpenGL wants columns, so they are sent with transpose = true.

fun rad(deg: Double) = deg * PI / 180.0
fun deg(rad: Double) = rad * 180.0 / PI

fun mul(a: FloatArray, b: FloatArray): FloatArray {
    val c = FloatArray(16)
    for (row in 0..3)
        for (col in 0..3) {
            var s = 0f
            for (k in 0..3) s += a[4 * row + k] * b[4 * k + col]
            c[4 * row + col] = s
        }
    return c
}

/** m * (x, y, z, w), without the last component */
fun apply(m: FloatArray, p: FloatArray, w: Float): FloatArray {
    val r = FloatArray(3)
    for (row in 0..2) r[row] = m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3] * w
    return r
}

fun fromJoml(m: Matrix4f): FloatArray {
    val columns = m.get(FloatArray(16))
    return FloatArray(16) { columns[4 * (it % 4) + it / 4] }
}

fun floats(v: Vector3f) = floatArrayOf(v.x, v.y, v.z)

fun perspective(fovyDeg: Double, aspect: Float, near: Float, far: Float): FloatArray {
    val f = (1.0 / tan(rad(fovyDeg) / 2.0)).toFloat()
    return floatArrayOf(
        f / aspect, 0f, 0f, 0f,
        0f, f, 0f, 0f,
        0f, 0f, (far + near) / (near - far), 2f * far * near / (near - far),
        0f, 0f, -1f, 0f
    )
}

fun lookAt(eye: FloatArray, center: FloatArray, up: FloatArray): FloatArray {
    val z = unit(minus(eye, center))
    val x = unit(cross(up, z))
    val y = cross(z, x)
    return floatArrayOf(
        x[0], x[1], x[2], -dot(x, eye),
        y[0], y[1], y[2], -dot(y, eye),
        z[0], z[1], z[2], -dot(z, eye),
        0f, 0f, 0f, 1f
    )
}

fun minus(a: FloatArray, b: FloatArray) = floatArrayOf(a[0] - b[0], a[1] - b[1], a[2] - b[2])
fun dot(a: FloatArray, b: FloatArray) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
fun cross(a: FloatArray, b: FloatArray) =
    floatArrayOf(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

fun unit(a: FloatArray): FloatArray {
    val l = sqrt(dot(a, a))
    return floatArrayOf(a[0] / l, a[1] / l, a[2] / l)
}
