package cga.measure.accuracy

import org.joml.Matrix3dc
import org.joml.Matrix3fc
import org.joml.Matrix4dc
import org.joml.Matrix4fc

/** One way to compute the operations. */
internal interface Implementation {
    val name: String

    /** The result by columns, a factor as the only number, or null where this one has no such operation. */
    fun compute(
        operation: Operation,
        input: OracleCase.Input,
    ): DoubleArray?
}

internal fun Matrix4fc.numbers(): DoubleArray = get(FloatArray(16)).numbers()

internal fun Matrix3fc.numbers(): DoubleArray = get(FloatArray(9)).numbers()

internal fun Matrix4dc.numbers(): DoubleArray = get(DoubleArray(16))

internal fun Matrix3dc.numbers(): DoubleArray = get(DoubleArray(9))

internal fun Float.numbers(): DoubleArray = doubleArrayOf(toDouble())

private fun FloatArray.numbers() = DoubleArray(size) { this[it].toDouble() }
