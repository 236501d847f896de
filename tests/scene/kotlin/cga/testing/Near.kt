package cga.testing

import org.joml.Matrix3dc
import org.joml.Matrix3fc
import org.joml.Matrix4dc
import org.joml.Matrix4fc
import org.joml.Vector2dc
import org.joml.Vector2fc
import org.joml.Vector3dc
import org.joml.Vector3fc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import kotlin.math.abs

/** Largest relative error of rounding to a float, 2⁻²⁴: what the tolerances of float results are multiples of. */
const val FLOAT_ROUNDING = 1.0 / (1L shl 24)

/** The same of a double, 2⁻⁵³. */
const val DOUBLE_ROUNDING = 1.0 / (1L shl 53)

/**
 * Asserts that every number in [actual] is within [tolerance] of its like in [expected]; the message tells the worst of them.
 *
 * Takes numbers, and JOML's vectors and matrices of either precision, so that a float result can be held against a double truth.
 */
fun assertNear(expected: Any, actual: Any, tolerance: Double, what: String = "") {
    val wanted = numbers(expected)
    val found = numbers(actual)
    assertEquals(wanted.size, found.size, what)
    val errors = wanted.indices.map { i -> abs(wanted[i] - found[i]).let { if (it.isNaN()) Double.POSITIVE_INFINITY else it } }
    val worst = errors.indices.maxBy { errors[it] }
    assertTrue(errors[worst] <= tolerance) {
        "$what: number $worst is ${found[worst]} and should be ${wanted[worst]}, off by ${errors[worst]}, more than $tolerance\n$actual"
    }
}

private fun numbers(value: Any): DoubleArray =
    when (value) {
        is Number -> doubleArrayOf(value.toDouble())
        is Vector2fc -> doubleArrayOf(value.x().toDouble(), value.y().toDouble())
        is Vector2dc -> doubleArrayOf(value.x(), value.y())
        is Vector3fc -> doubleArrayOf(value.x().toDouble(), value.y().toDouble(), value.z().toDouble())
        is Vector3dc -> doubleArrayOf(value.x(), value.y(), value.z())
        is Matrix3fc -> value.get(FloatArray(9)).widened()
        is Matrix3dc -> value.get(DoubleArray(9))
        is Matrix4fc -> value.get(FloatArray(16)).widened()
        is Matrix4dc -> value.get(DoubleArray(16))
        else -> error("no numbers are known of $value")
    }

private fun FloatArray.widened() = DoubleArray(size) { this[it].toDouble() }
