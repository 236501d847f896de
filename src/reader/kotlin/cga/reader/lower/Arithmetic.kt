package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.spirv.Instruction
import cga.reader.spirv.Op
import cga.reader.spirv.Type

/** Instructions that do the same with each component of their operands. */
internal class Arithmetic(private val emitter: Emitter) {
    /** The result, or null where [instruction] is of another sort. */
    fun lower(instruction: Instruction, scope: Scope): Value? {
        val op = instruction.op
        val type = scope.type(instruction.type)

        fun operand(i: Int) = scope.value(instruction.operands[i])
        DIRECT[op]?.let { return each(type, it, List(instruction.operands.size, ::operand)) }
        REVERSED[op]?.let { return each(type, it, listOf(operand(1), operand(0))) }
        return when (op) {
            Op.BITCAST -> each(type, bitcast(operand(0).type.componentType, type.componentType), listOf(operand(0)))
            Op.VECTOR_TIMES_SCALAR, Op.MATRIX_TIMES_SCALAR -> {
                val factor = operand(1).cell
                Value(type, operand(0).cells.map { emitter.op(Operation.MUL, it, factor) }.toIntArray())
            }
            Op.ANY -> reduce(type, Operation.OR, operand(0))
            Op.ALL -> reduce(type, Operation.AND, operand(0))
            else -> null
        }
    }

    /** [operation] on the numbers of [operands], one after the other; a single number goes with all of a vector. */
    fun each(type: Type, operation: Operation, operands: List<Value>): Value {
        fun cell(
            operand: Int,
            i: Int,
        ) = operands.getOrNull(operand)?.cells?.let { if (it.size == 1) it[0] else it[i] } ?: 0
        val unsigned = if ((type.componentType as? Type.Integer)?.isSigned == false) 1 else 0
        return Value(
            type,
            IntArray(type.cells) { emitter.op(operation, cell(0, it), cell(1, it), if (operands.size > 2) cell(2, it) else unsigned) },
        )
    }

    private fun reduce(
        type: Type,
        operation: Operation,
        operand: Value,
    ) = Value(type, operand.cells.reduce { all, next -> emitter.op(operation, all, next) })

    private fun bitcast(from: Type, to: Type) = when {
        from == Type.Float -> Operation.FLOAT_BITS
        to == Type.Float -> Operation.BITS_FLOAT
        else -> Operation.INT_CAST
    }

    private companion object {
        val DIRECT = mapOf(
            Op.F_NEGATE to Operation.NEG,
            Op.F_ADD to Operation.ADD,
            Op.F_SUB to Operation.SUB,
            Op.F_MUL to Operation.MUL,
            Op.F_DIV to Operation.DIV,
            Op.F_MOD to Operation.MOD,
            Op.F_REM to Operation.REM,
            Op.S_NEGATE to Operation.INT_NEG,
            Op.I_ADD to Operation.INT_ADD,
            Op.I_SUB to Operation.INT_SUB,
            Op.I_MUL to Operation.INT_MUL,
            Op.U_DIV to Operation.INT_DIV,
            Op.S_DIV to Operation.INT_DIV,
            Op.U_MOD to Operation.INT_MOD,
            Op.S_MOD to Operation.INT_MOD,
            Op.S_REM to Operation.INT_REM,
            Op.SHIFT_LEFT_LOGICAL to Operation.SHIFT_LEFT,
            Op.SHIFT_RIGHT_ARITHMETIC to Operation.SHIFT_RIGHT,
            Op.SHIFT_RIGHT_LOGICAL to Operation.SHIFT_RIGHT_LOGICAL,
            Op.BITWISE_AND to Operation.BIT_AND,
            Op.BITWISE_OR to Operation.BIT_OR,
            Op.BITWISE_XOR to Operation.BIT_XOR,
            Op.NOT to Operation.BIT_NOT,
            Op.CONVERT_F_TO_S to Operation.FLOAT_TO_INT,
            Op.CONVERT_F_TO_U to Operation.FLOAT_TO_INT,
            Op.CONVERT_S_TO_F to Operation.INT_TO_FLOAT,
            Op.CONVERT_U_TO_F to Operation.INT_TO_FLOAT,
            Op.IS_NAN to Operation.IS_NAN,
            Op.IS_INF to Operation.IS_INF,
            Op.LOGICAL_EQUAL to Operation.EQUAL,
            Op.LOGICAL_NOT_EQUAL to Operation.NOT_EQUAL,
            Op.LOGICAL_AND to Operation.AND,
            Op.LOGICAL_OR to Operation.OR,
            Op.LOGICAL_NOT to Operation.NOT,
            Op.SELECT to Operation.SELECT,
            Op.I_EQUAL to Operation.EQUAL,
            Op.I_NOT_EQUAL to Operation.NOT_EQUAL,
            Op.F_ORD_EQUAL to Operation.EQUAL,
            Op.F_ORD_NOT_EQUAL to Operation.NOT_EQUAL,
            Op.F_UNORD_NOT_EQUAL to Operation.NOT_EQUAL,
            Op.U_LESS_THAN to Operation.LESS,
            Op.S_LESS_THAN to Operation.LESS,
            Op.F_ORD_LESS_THAN to Operation.LESS,
            Op.U_LESS_THAN_EQUAL to Operation.LESS_EQUAL,
            Op.S_LESS_THAN_EQUAL to Operation.LESS_EQUAL,
            Op.F_ORD_LESS_THAN_EQUAL to Operation.LESS_EQUAL,
            Op.DPDX to Operation.DPDX,
            Op.DPDY to Operation.DPDY,
        )

        /** a > b is b < a. */
        val REVERSED = mapOf(
            Op.U_GREATER_THAN to Operation.LESS,
            Op.S_GREATER_THAN to Operation.LESS,
            Op.F_ORD_GREATER_THAN to Operation.LESS,
            Op.U_GREATER_THAN_EQUAL to Operation.LESS_EQUAL,
            Op.S_GREATER_THAN_EQUAL to Operation.LESS_EQUAL,
            Op.F_ORD_GREATER_THAN_EQUAL to Operation.LESS_EQUAL,
        )
    }
}
