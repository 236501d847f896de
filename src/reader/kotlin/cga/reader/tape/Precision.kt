package cga.reader.tape

import cga.reader.shader.Operation
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.acosh
import kotlin.math.asin
import kotlin.math.atanh
import kotlin.math.ceil
import kotlin.math.cosh
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.max
import kotlin.math.pow
import kotlin.math.sign
import kotlin.math.sqrt
import kotlin.math.truncate

/**
 * What GLSL allows an operation in floats to be off, and how it hands on the errors of its operands.
 *
 * The allowances are those of GLSL 4.60, section 4.7.1, as docs/accuracy.md has them: sums and products 1 ulp, quotients 2.5, `inversesqrt` 2,
 * `exp2` 3 + 2|x|, `log2` 3 and 2⁻²¹ absolute from 0.5 to 2; `sqrt` and `pow` inherit. GLSL leaves the
 * other functions open.
 */
internal object Precision {
    /** An ulp of x is at most this share of x. */
    const val ULP = 1.0 / (1 shl 23)

    /** Smaller numbers than this, 2⁻¹²⁶, may become 0. */
    private const val UNDERFLOW = 1.1754943508222875e-38
    private const val EXACT_INTEGERS = 1 shl 24
    private const val LOG_ERROR = 1.0 / (1 shl 21)

    /**
     * What Mesa's llvmpipe (22.3.6) was measured to need, at 4096 numbers each, as absolute errors. It computes sine and cosine as Cephes does, the
     * others by Mesa's own polynomials and formulas (`src/compiler/nir/nir_builtin_builder.c`). Measured at most, in ulps of 1: sin and cos 0.62 up
     * to 20, tanh 1.2, asinh 2.2, acosh 2.9, atanh 1.5, atan 27 and asin 3300.
     */
    private const val SINE_ERROR = ULP
    private const val AREA_ERROR = 6 * ULP
    private const val ARC_TANGENT_ERROR = 40 * ULP
    private const val ARC_SINE_ERROR = 5000 * ULP

    /** sinh and cosh relative to cosh; measured 2.4. */
    private const val HYPERBOLIC_ERROR = 6 * ULP

    /** The error of [value], made by [operation] of [x] and [y], which are off by [ex] and [ey]. */
    fun error(operation: Operation, value: Double, x: Double, ex: Double, y: Double, ey: Double): Double =
        when (operation) {
            Operation.NEG, Operation.ABS -> ex
            // Where it is clear which one it is, the other does not matter.
            Operation.MIN, Operation.MAX -> if (abs(x - y) > ex + ey) (if (value == x) ex else ey) else max(ex, ey)
            // A compiler may take the terms of a sum in another order; then it is the largest that is rounded.
            Operation.ADD, Operation.SUB -> rounded(max(abs(value), max(abs(x), abs(y))), ex + ey, 1.0)
            Operation.INT_TO_FLOAT -> if (abs(x) <= EXACT_INTEGERS) ex else rounded(value, ex, 1.0)
            Operation.MUL -> rounded(value, abs(x) * ey + abs(y) * ex + ex * ey, 1.0)
            Operation.DIV -> quotient(value, ex, y, ey)
            Operation.SQRT -> rounded(value, spread(value, x, ex) { sqrt(max(it, 0.0)) }, 4.5)
            Operation.INVERSE_SQRT ->
                if (x <= ex) Double.POSITIVE_INFINITY else rounded(value, spread(value, x, ex) { 1 / sqrt(it) }, 2.0)
            Operation.POW -> power(value, x, ex, y, ey)
            Operation.EXP, Operation.EXP2, Operation.LOG, Operation.LOG2 -> logarithmic(operation, value, x, ex)
            Operation.MOD, Operation.REM -> remainder(x, ex, y, ey)
            Operation.FRACT -> if (floor(x - ex) == floor(x + ex)) rounded(value, ex, 1.0) else 1.0
            Operation.FLOOR -> spread(value, x, ex, ::floor)
            Operation.CEIL -> spread(value, x, ex) { ceil(it) }
            Operation.TRUNC, Operation.FLOAT_TO_INT -> spread(value, x, ex) { truncate(it) }
            Operation.ROUND -> spread(value, x, ex) { Math.rint(it) }
            Operation.SIGN -> spread(value, x, ex) { sign(it) }
            // A difference of numbers that are not on the tape.
            Operation.DPDX, Operation.DPDY -> Double.POSITIVE_INFINITY
            else -> transcendental(operation, value, x, ex, y, ey) ?: if (ex + ey == 0.0) 0.0 else Double.POSITIVE_INFINITY
        }

    private fun rounded(
        value: Double,
        error: Double,
        ulps: Double,
    ) = error + ulps * ULP * (abs(value) + error) + UNDERFLOW

    /** How far the results of a monotonic [function] lie apart. */
    private inline fun spread(
        value: Double,
        x: Double,
        ex: Double,
        function: (Double) -> Double,
    ) = if (ex == 0.0) 0.0 else max(abs(function(x + ex) - value), abs(function(x - ex) - value))

    private fun quotient(value: Double, ex: Double, y: Double, ey: Double): Double {
        val smallest = abs(y) - ey
        return if (smallest <= 0) Double.POSITIVE_INFINITY else rounded(value, (ex + abs(value) * ey) / smallest, 2.5)
    }

    /** x^y of x ≥ 0, as exp2(y·log2(x)); largest and smallest at the corners of what x and y may be. */
    private fun power(value: Double, x: Double, ex: Double, y: Double, ey: Double): Double {
        if (x < 0 || (x <= ex && y <= ey)) return Double.POSITIVE_INFINITY
        val low = max(x - ex, 0.0)
        val corners = listOf(low, x + ex).flatMap { base -> listOf(base.pow(y - ey), base.pow(y + ey)) }
        val exponent = if (x == 0.0) 0.0 else abs(y * ln(x) / ln(2.0))
        val logError = if (x in 0.5..2.0) LOG_ERROR else 3 * ULP * exponent / max(abs(y), ULP)
        val factor = 2.0.pow((abs(y) + ey) * logError + ULP * exponent) * (1 + (3 + 2 * exponent) * ULP)
        return max(corners.max() * factor - value, value - corners.min() / factor) + UNDERFLOW
    }

    private fun logarithmic(operation: Operation, value: Double, x: Double, ex: Double): Double =
        when (operation) {
            Operation.EXP -> rounded(value, spread(value, x, ex, Math::exp), 3 + 2 * abs(x))
            Operation.EXP2 -> rounded(value, spread(value, x, ex) { 2.0.pow(it) }, 3 + 2 * abs(x))
            else -> {
                val unit = if (operation == Operation.LOG) 1.0 else ln(2.0)
                val own = if (x in 0.5..2.0) LOG_ERROR else 3 * ULP * abs(value)
                if (x <= ex) Double.POSITIVE_INFINITY else rounded(value, spread(value, x, ex) { ln(it) / unit } + own, 1.0)
            }
        }

    /** x - y·floor(x/y): a step of y where the quotient is nearly whole. */
    private fun remainder(x: Double, ex: Double, y: Double, ey: Double): Double {
        val quotient = x / y
        val error = quotient(quotient, ex, y, ey)
        val step = if (floor(quotient - error) == floor(quotient + error)) 0.0 else abs(y)
        return step + ex + (abs(quotient) + 1) * (ey + 2 * ULP * abs(y)) + ULP * abs(x) + UNDERFLOW
    }

    /** Null for what is exact where its operands are: integers, and the bits of a float. */
    private fun transcendental(
        operation: Operation,
        value: Double,
        x: Double,
        ex: Double,
        y: Double,
        ey: Double,
    ): Double? =
        when (operation) {
            Operation.SIN, Operation.COS -> ex + SINE_ERROR * (1 + abs(x))
            Operation.TAN -> (1 + value * value) * (ex + SINE_ERROR * (1 + abs(x))) * 2
            Operation.ASIN -> spread(value, x, ex) { asin(it.coerceIn(-1.0, 1.0)) } + ARC_SINE_ERROR
            Operation.ACOS -> spread(value, x, ex) { acos(it.coerceIn(-1.0, 1.0)) } + ARC_SINE_ERROR
            Operation.ATAN -> ex + ARC_TANGENT_ERROR
            Operation.ATAN2 -> {
                val nearest = max(abs(x) - ex, abs(y) - ey)
                if (nearest <= 0) Double.POSITIVE_INFINITY else (ex + ey) / nearest + ARC_TANGENT_ERROR
            }
            Operation.SINH, Operation.COSH -> cosh(abs(x) + ex) * (ex + HYPERBOLIC_ERROR)
            Operation.TANH -> ex + AREA_ERROR
            Operation.ASINH -> ex + AREA_ERROR
            Operation.ACOSH -> spread(value, x, ex) { acosh(max(it, 1.0)) } + AREA_ERROR
            Operation.ATANH -> spread(value, x, ex, ::atanh) + AREA_ERROR
            else -> null
        }
}
