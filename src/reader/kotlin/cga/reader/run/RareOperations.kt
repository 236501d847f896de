package cga.reader.run

import cga.reader.shader.Operation
import kotlin.math.abs
import kotlin.math.acosh
import kotlin.math.asinh
import kotlin.math.atan2
import kotlin.math.atanh
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sign
import kotlin.math.truncate

/** Operations that are not worth a place in the loop of [Machine]; [unsigned] of those on integers. */
internal fun rare(operation: Operation, x: Double, y: Double, unsigned: Boolean): Double =
    when (operation) {
        Operation.MOD -> x - y * floor(x / y)
        Operation.REM -> x - y * truncate(x / y)
        Operation.SIGN -> sign(x)
        Operation.FLOOR -> floor(x)
        Operation.CEIL -> ceil(x)
        Operation.TRUNC -> truncate(x)
        Operation.ROUND -> Math.rint(x)
        Operation.FRACT -> x - floor(x)
        Operation.EXP -> kotlin.math.exp(x)
        Operation.EXP2 -> 2.0.pow(x)
        Operation.LOG -> ln(x)
        Operation.LOG2 -> kotlin.math.log2(x)
        Operation.SIN -> kotlin.math.sin(x)
        Operation.COS -> kotlin.math.cos(x)
        Operation.TAN -> kotlin.math.tan(x)
        Operation.ASIN -> kotlin.math.asin(x)
        Operation.ACOS -> kotlin.math.acos(x)
        Operation.ATAN -> kotlin.math.atan(x)
        Operation.ATAN2 -> atan2(x, y)
        Operation.SINH -> kotlin.math.sinh(x)
        Operation.COSH -> kotlin.math.cosh(x)
        Operation.TANH -> kotlin.math.tanh(x)
        Operation.ASINH -> asinh(x)
        Operation.ACOSH -> acosh(x)
        Operation.ATANH -> atanh(x)
        Operation.IS_NAN -> truth(x.isNaN())
        Operation.IS_INF -> truth(x.isInfinite())
        Operation.FLOAT_TO_INT -> if (unsigned) x.toLong().coerceIn(0, UInt.MAX_VALUE.toLong()).toDouble() else x.toInt().toDouble()
        Operation.INT_TO_FLOAT -> x
        Operation.FLOAT_BITS -> wrapped(x.toFloat().toRawBits().toLong(), unsigned)
        Operation.BITS_FLOAT -> Float.fromBits(x.toLong().toInt()).toDouble()
        else -> wrapped(integer(operation, x.toLong(), y.toLong()), unsigned)
    }

/** What is divided by 0 gives 0; GLSL leaves it open. */
private fun integer(operation: Operation, x: Long, y: Long): Long =
    when (operation) {
        Operation.INT_SUB -> x - y
        Operation.INT_MUL -> x * y
        Operation.INT_DIV -> if (y == 0L) 0 else x / y
        Operation.INT_REM -> if (y == 0L) 0 else x % y
        Operation.INT_MOD -> if (y == 0L) 0 else Math.floorMod(x, y)
        Operation.INT_NEG -> -x
        Operation.SHIFT_LEFT -> if (y in 0..31) x shl y.toInt() else 0
        Operation.SHIFT_RIGHT -> if (y in 0..31) x shr y.toInt() else 0
        Operation.SHIFT_RIGHT_LOGICAL -> if (y in 0..31) (x and BITS) shr y.toInt() else 0
        Operation.BIT_AND -> x and y
        Operation.BIT_OR -> x or y
        Operation.BIT_XOR -> x xor y
        Operation.BIT_NOT -> x.inv()
        Operation.INT_CAST -> x
        else -> error("$operation has no place here")
    }

/** The integer of 32 bits that the last bits of [x] are. */
internal fun wrapped(
    x: Long,
    unsigned: Boolean,
): Double = if (unsigned) (x and BITS).toDouble() else x.toInt().toDouble()

internal fun truth(x: Boolean): Double = if (x) 1.0 else 0.0

internal fun smaller(x: Double, y: Double): Double = if (x < y || y.isNaN()) x else y

internal fun larger(x: Double, y: Double): Double = if (x > y || y.isNaN()) x else y

/** x^y as GLSL has it, which knows no powers of negative numbers. */
internal fun power(x: Double, y: Double): Double = if (x < 0) Double.NaN else x.pow(y)

/** Element [index] of [count], [stride] cells each; the nearest one where there is none of that index. */
internal fun place(
    index: Double,
    stride: Int,
    count: Int,
): Double = abs(index.coerceIn(0.0, (count - 1).toDouble())) * stride

private const val BITS = 0xffffffffL
