package cga.reader.tape

import cga.reader.shader.Operation
import cga.reader.shader.Source
import kotlin.math.abs
import kotlin.math.max

/**
 * How far off a processor of graphics may be that computes in floats what is on [tape], for every entry: a running error analysis
 * (N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition 2002, section 3.3). Every operation hands on the errors
 * of its operands and adds its own; [Precision] says how much. Inputs and uniforms are taken as exact, so give the machine floats; textures as the same
 * wherever the coordinates err.
 *
 * Where a comparison could go either way, so could what follows: see [isDecided].
 */
public class RunningError(private val tape: Tape) {
    private val errors = DoubleArray(tape.size)

    /** Whether every branch goes the same way however the errors fall. Otherwise floats may have computed something else altogether. */
    public var isDecided: Boolean = true
        private set

    init {
        for (entry in errors.indices) {
            val error = error(entry)
            val value = tape.value(entry)
            errors[entry] =
                if (error.isNaN() || !value.isFinite() || abs(value) + error > Float.MAX_VALUE) Double.POSITIVE_INFINITY else error
            val isBranch = tape.operation(entry) == Operation.BRANCH || tape.operation(entry) == Operation.SWITCH
            if (isBranch && errors[entry] > 0) isDecided = false
        }
    }

    /** At most so far off is what [reference] stands for; infinite where nothing can be said. */
    public fun of(reference: Int): Double {
        if (reference >= 0) return errors[reference]
        val constant = tape.source(reference) as? Source.Constant ?: return 0.0
        // One of a formula need not be a float.
        return if (constant.value.toFloat().toDouble() == constant.value) 0.0 else abs(constant.value) * Precision.ULP
    }

    private fun error(entry: Int): Double {
        val operation = tape.operation(entry)
        if (operation == Operation.TEXTURE || operation == Operation.TEXTURE_SIZE) return 0.0
        val value = tape.value(entry)
        val count = tape.operandCount(entry)
        val first = tape.operand(entry, 0)
        val second = if (count > 1) tape.operand(entry, 1) else first
        val x = tape.value(first)
        val y = tape.value(second)
        val ex = of(first)
        val ey = of(second)
        return when (operation) {
            Operation.SELECT -> select(ex, second, tape.operand(entry, 2))
            Operation.BRANCH, Operation.SWITCH, Operation.NOT -> ex
            Operation.AND -> if ((x == 0.0 && ex == 0.0) || (y == 0.0 && ey == 0.0)) 0.0 else max(ex, ey)
            Operation.OR -> if ((x == 1.0 && ex == 0.0) || (y == 1.0 && ey == 0.0)) 0.0 else max(ex, ey)
            Operation.LESS, Operation.LESS_EQUAL, Operation.EQUAL, Operation.NOT_EQUAL -> {
                val isOpen = ex + ey > 0 && !(abs(x - y) > ex + ey)
                if (isOpen) 1.0 else 0.0
            }
            else -> Precision.error(operation, value, x, ex, y, ey)
        }
    }

    /** Where the condition is open, either may come. */
    private fun select(open: Double, a: Int, b: Int): Double {
        val taken = if (open == 0.0) 0.0 else abs(tape.value(a) - tape.value(b))
        return taken + max(of(a), of(b))
    }
}
