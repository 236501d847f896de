package cga.reader.tape

import cga.reader.shader.Operation
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.asin
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.max
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * What GLSL allows an operation in floats to be off, and how it hands on the errors of its operands.
 *
 * The allowances are those of GLSL 4.60, section 4.7.1, as docs/accuracy.md has them: sums and products 1 ulp, quotients 2.5, `inversesqrt` 2,
 * `exp2` 3 + 2|x|, `log2` 3 and 2⁻²¹ absolute from 0.5 to 2; `sqrt` and `pow` inherit. GLSL says nothing of the other
 * functions; for them it is what Mesa's llvmpipe was measured to need, see the constants.
 */
internal object Precision {
    /** An ulp of x is at most this share of x. */
    const val ULP = 1.0 / (1 shl 23)

    /** Smaller numbers than this, 2⁻¹²⁶, may become 0. */
    private const val UNDERFLOW = 1.1754943508222875e-38
    private const val LOG_ERROR = 1.0 / (1 shl 21)

    /** sin and cos, absolute, for each unit of the angle beyond the first. */
    private const val SINE_ERROR = 2 * ULP

    /** asin, acos and atan, absolute: polynomials of Mesa's. */
    private const val ARC_ERROR = 1e-4

    /** sinh, cosh and tanh are made of exp: relative to what is subtracted. */
    private const val HYPERBOLIC_ULPS = 8.0

    /** The error of [value], made by [operation] of [x] and [y], which are off by [ex] and [ey]. */
    fun error(
        operation: Operation,
        value: Double,
        x: Double,
        ex: Double,
        y: Double,
        ey: Double,
    ): Double =
        when (operation) {
            Operation.NEG, Operation.ABS -> ex
            Operation.MIN, Operation.MAX -> max(ex, ey)
            Operation.ADD, Operation.SUB -> rounded(value, ex + ey, 1.0)
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
            Operation.CEIL -> spread(value, x, ex) { kotlin.math.ceil(it) }
            Operation.TRUNC, Operation.FLOAT_TO_INT -> spread(value, x, ex) { kotlin.math.truncate(it) }
            Operation.ROUND -> spread(value, x, ex) { Math.rint(it) }
            Operation.SIGN -> spread(value, x, ex) { kotlin.math.sign(it) }
            // A difference of numbers that are not on the tape.
            Operation.DPDX, Operation.DPDY -> Double.POSITIVE_INFINITY
            else -> transcendental(operation, value, x, ex) ?: if (ex + ey == 0.0) 0.0 else Double.POSITIVE_INFINITY
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

    private fun quotient(
        value: Double,
        ex: Double,
        y: Double,
        ey: Double,
    ): Double {
        val smallest = abs(y) - ey
        return if (smallest <= 0) Double.POSITIVE_INFINITY else rounded(value, (ex + abs(value) * ey) / smallest, 2.5)
    }

    /** x^y of x ≥ 0, as exp2(y·log2(x)); largest and smallest at the corners of what x and y may be. */
    private fun power(
        value: Double,
        x: Double,
        ex: Double,
        y: Double,
        ey: Double,
    ): Double {
        if (x < 0 || (x <= ex && y <= ey)) return Double.POSITIVE_INFINITY
        val low = max(x - ex, 0.0)
        val corners = listOf(low, x + ex).flatMap { base -> listOf((base).pow(y - ey), base.pow(y + ey)) }
        val exponent = if (x == 0.0) 0.0 else abs(y * ln(x) / ln(2.0))
        val logError = if (x in 0.5..2.0) LOG_ERROR else 3 * ULP * exponent / max(abs(y), ULP)
        val factor = 2.0.pow((abs(y) + ey) * logError + ULP * exponent) * (1 + (3 + 2 * exponent) * ULP)
        return max(corners.max() * factor - value, value - corners.min() / factor) + UNDERFLOW
    }

    private fun logarithmic(
        operation: Operation,
        value: Double,
        x: Double,
        ex: Double,
    ): Double =
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
    private fun remainder(
        x: Double,
        ex: Double,
        y: Double,
        ey: Double,
    ): Double {
        val quotient = x / y
        val error = quotient(quotient, ex, y, ey)
        val step = if (floor(quotient - error) == floor(quotient + error)) 0.0 else abs(y)
        return step + ex + (abs(quotient) + 1) * (ey + 2 * ULP * abs(y)) + ULP * abs(x) + UNDERFLOW
    }

    private fun transcendental(
        operation: Operation,
        value: Double,
        x: Double,
        ex: Double,
    ): Double? =
        when (operation) {
            Operation.SIN, Operation.COS -> ex + SINE_ERROR * (1 + abs(x))
            Operation.TAN -> (1 + value * value) * (ex + SINE_ERROR * (1 + abs(x)) * 2) + 3 * ULP * abs(value)
            Operation.ASIN -> spread(value, x, ex) { asin(it.coerceIn(-1.0, 1.0)) } + ARC_ERROR
            Operation.ACOS -> spread(value, x, ex) { acos(it.coerceIn(-1.0, 1.0)) } + ARC_ERROR
            Operation.ATAN, Operation.ATAN2 -> null
            Operation.SINH, Operation.COSH -> rounded(value, kotlin.math.cosh(abs(x) + ex) * (ex + HYPERBOLIC_ULPS * ULP), 1.0)
            Operation.TANH -> rounded(value, ex + HYPERBOLIC_ULPS * ULP, 1.0)
            else -> null
        }
}
