package cga.measure.accuracy

import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.log2
import kotlin.math.max
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * A number, and how far off a shader that computes it in floats may be.
 *
 * Every operation adds what GLSL 4.10 allows it to the errors that its operands bring along, carried over by its slope: a running error
 * analysis (N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition 2002, section 3.3). The allowances are those of
 * the specification's section "Range and Precision" (4.7.1 in GLSL 4.60): sums and products correctly rounded, the direction of rounding
 * left open, so less than 1 ulp; quotients 2.5 ulp; `inversesqrt` 2 ulp; `log2` 3 ulp, and 2⁻²¹ absolute from 0.5 to 2; `exp2`
 * (3 + 2|x|) ulp; `sqrt` = 1/inversesqrt and `pow` = exp2(y·log2(x)) inherit. `#version 330` promises none of this.
 *
 * @param value the true one.
 * @param error at most |float − [value]|; infinite where nothing can be said.
 */
internal class Bounded(
    val value: Double,
    val error: Double = 0.0,
) {
    operator fun plus(other: Bounded): Bounded = rounded(value + other.value, error + other.error)

    operator fun minus(other: Bounded): Bounded = rounded(value - other.value, error + other.error)

    operator fun times(other: Bounded): Bounded =
        rounded(value * other.value, abs(value) * other.error + abs(other.value) * error + error * other.error)

    operator fun div(other: Bounded): Bounded {
        val smallest = abs(other.value) - other.error
        if (smallest <= 0) return Bounded(value / other.value, Double.POSITIVE_INFINITY)
        val quotient = value / other.value
        return rounded(quotient, (error + abs(quotient) * other.error) / smallest, 2.5)
    }

    operator fun unaryMinus(): Bounded = Bounded(-value, error)

    /** `clamp(x, 0.0, 1.0)`, which is exact and brings no two numbers further apart. */
    fun clamp(): Bounded = Bounded(value.coerceIn(0.0, 1.0), error)

    /** `inversesqrt(x)` of a positive number. */
    fun inverseSqrt(): Bounded {
        val smallest = value - error
        if (smallest <= 0) return Bounded(1 / sqrt(value), Double.POSITIVE_INFINITY)
        return rounded(1 / sqrt(value), 1 / sqrt(smallest) - 1 / sqrt(value), 2.0)
    }

    fun sqrt(): Bounded = Bounded(1.0) / inverseSqrt()

    /** `pow(x, k)` of a number in 0…1, and 0 where it is 0: x^k is steepest at the upper end for k > 1 and at the lower for k < 1. */
    fun pow(k: Double): Bounded {
        val power = if (value > 0) value.pow(k) else 0.0
        val highest = (value + error).pow(k)
        val lowest = if (value > error) (value - error).pow(k) else 0.0
        val factor = powFactor(max(value, SMALLEST_BASE), k)
        return Bounded(power, max(highest * factor - power, power - lowest / factor) + UNDERFLOW)
    }

    private fun rounded(
        value: Double,
        error: Double,
        ulps: Double = 1.0,
    ) = Bounded(value, error + ulps * ULP * (abs(value) + error) + UNDERFLOW)

    companion object {
        /** An ulp of x is at most this share of x. */
        const val ULP = 1.0 / (1 shl 23)

        /** Smaller numbers than this, 2⁻¹²⁶, may become 0. */
        private const val UNDERFLOW = 1.1754943508222875e-38

        /** Below it x^k is nothing for every k that is worth a highlight, and its logarithm no matter. */
        private const val SMALLEST_BASE = 1.0 / 1024
        private const val LOG_ERROR = 1.0 / (1 shl 21)

        /** By what factor exp2(k·log2(x)) may be off: the exponent's error, which grows with k, and then that of `exp2`. */
        private fun powFactor(
            x: Double,
            k: Double,
        ): Double {
            val exponent = abs(k * log2(x))
            val logError = if (x >= 0.5) LOG_ERROR else 3 * ULP * abs(log2(x))
            val exponentError = k * logError + ULP * (exponent + k * logError)
            return exp2(exponentError) * (1 + (3 + 2 * exponent) * ULP)
        }

        private fun exp2(x: Double) = kotlin.math.exp(x * ln(2.0))
    }
}

/** Three of them. */
internal class BoundedVector(
    val x: Bounded,
    val y: Bounded,
    val z: Bounded,
) {
    operator fun plus(other: BoundedVector): BoundedVector = BoundedVector(x + other.x, y + other.y, z + other.z)

    operator fun minus(other: BoundedVector): BoundedVector = BoundedVector(x - other.x, y - other.y, z - other.z)

    operator fun times(factor: Bounded): BoundedVector = BoundedVector(x * factor, y * factor, z * factor)

    operator fun times(other: BoundedVector): BoundedVector = BoundedVector(x * other.x, y * other.y, z * other.z)

    operator fun unaryMinus(): BoundedVector = BoundedVector(-x, -y, -z)

    fun dot(other: BoundedVector): Bounded = x * other.x + y * other.y + z * other.z

    fun normalize(): BoundedVector = this * dot(this).inverseSqrt()

    operator fun get(i: Int): Bounded = if (i == 0) {
        x
    } else if (i == 1) {
        y
    } else {
        z
    }
}
