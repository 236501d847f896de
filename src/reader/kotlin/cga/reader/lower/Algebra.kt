package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.shader.Operation.ADD
import cga.reader.shader.Operation.DIV
import cga.reader.shader.Operation.MUL
import cga.reader.shader.Operation.NEG
import cga.reader.shader.Operation.SUB
import cga.reader.spirv.Instruction
import cga.reader.spirv.Op
import cga.reader.spirv.Type

/** Dot products, and what matrices do, as their formulas of single numbers. */
internal class Algebra(private val emitter: Emitter) {
    /** The result, or null where [instruction] is of another sort. */
    fun lower(instruction: Instruction, scope: Scope): Value? {
        val type = scope.type(instruction.type)

        fun operand(i: Int) = scope.value(instruction.operands[i])
        return when (instruction.op) {
            Op.DOT -> Value(type, dot(operand(0).cells, operand(1).cells))
            Op.MATRIX_TIMES_VECTOR -> Value(type, times(operand(0), operand(1).cells))
            Op.VECTOR_TIMES_MATRIX -> Value(type, operand(1).parts().map { dot(operand(0).cells, it.cells) }.toIntArray())
            Op.MATRIX_TIMES_MATRIX -> Value(type, operand(1).parts().flatMap { times(operand(0), it.cells).asList() }.toIntArray())
            Op.OUTER_PRODUCT ->
                Value(type, operand(1).cells.flatMap { b -> operand(0).cells.map { op(MUL, it, b) } }.toIntArray())
            Op.TRANSPOSE -> Value(type, rows(operand(0)).flatMap { it.asList() }.toIntArray())
            else -> null
        }
    }

    fun dot(
        a: IntArray,
        b: IntArray,
    ): Int = a.indices.map { op(MUL, a[it], b[it]) }.reduce { sum, next -> op(ADD, sum, next) }

    fun determinant(matrix: Value): Int = determinant(matrix.parts().map { it.cells })

    /** By cofactors, over the determinant. */
    fun inverse(type: Type, matrix: Value): Value {
        val columns = matrix.parts().map { it.cells }
        val cofactors = columns.indices.map { column -> columns.indices.map { row -> cofactor(columns, column, row) } }
        val determinant = dot(columns[0], cofactors[0].toIntArray())
        return Value(type, columns.indices.flatMap { j -> columns.indices.map { i -> op(DIV, cofactors[i][j], determinant) } }.toIntArray())
    }

    private fun times(matrix: Value, vector: IntArray) = rows(matrix).map { dot(it, vector) }.toIntArray()

    private fun rows(matrix: Value): List<IntArray> {
        val columns = matrix.parts()
        return columns[0].cells.indices.map { row -> IntArray(columns.size) { columns[it].cells[row] } }
    }

    private fun determinant(columns: List<IntArray>): Int {
        if (columns.size == 1) return columns[0][0]
        if (columns.size == 2) return op(SUB, op(MUL, columns[0][0], columns[1][1]), op(MUL, columns[1][0], columns[0][1]))
        return dot(columns[0], IntArray(columns.size) { cofactor(columns, 0, it) })
    }

    private fun cofactor(columns: List<IntArray>, column: Int, row: Int): Int {
        val minor = (columns - setOf(columns[column])).map { cells -> cells.filterIndexed { i, _ -> i != row }.toIntArray() }
        return determinant(minor).let { if ((column + row) % 2 == 0) it else op(NEG, it) }
    }

    private fun op(operation: Operation, a: Int, b: Int = 0) = emitter.op(operation, a, b)
}
