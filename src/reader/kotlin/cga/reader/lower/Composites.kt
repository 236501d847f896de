package cga.reader.lower

import cga.reader.spirv.Instruction
import cga.reader.spirv.Op
import cga.reader.spirv.Storage

/** Instructions that put numbers together or pick some out, which costs nothing when they run, unless the index is computed. */
internal class Composites(
    private val emitter: Emitter,
    private val memory: Memory,
) {
    /** The result, or null where [instruction] is of another sort. */
    fun lower(instruction: Instruction, scope: Scope): Value? {
        val operands = instruction.operands
        val type = scope.type(instruction.type)

        fun operand(i: Int) = scope.value(operands[i])
        return when (instruction.op) {
            Op.COMPOSITE_CONSTRUCT -> Value(type, operands.flatMap { scope.value(it).cells.asList() }.toIntArray())
            Op.COMPOSITE_EXTRACT -> instruction.from(1).fold(operand(0)) { whole, index -> whole.part(index) }
            Op.COMPOSITE_INSERT -> insert(operand(1), instruction.from(2), operand(0))
            Op.VECTOR_SHUFFLE -> (operand(0).cells + operand(1).cells).let { both ->
                // -1 is a component that nobody asks for.
                Value(type, instruction.from(2).map { both[if (it == -1) 0 else it] }.toIntArray())
            }
            Op.COPY_OBJECT, Op.IMAGE -> Value(type, operand(0).cells)
            Op.UNDEF -> Value(type, IntArray(type.cells) { emitter.constant(0.0) })
            Op.VECTOR_EXTRACT_DYNAMIC -> memory.load(element(operand(0), operand(1)))
            Op.VECTOR_INSERT_DYNAMIC -> {
                val element = element(operand(0), operand(2))
                memory.store(element, operand(1))
                memory.load(Pointer(element.variable, type, element.variable.base))
            }
            else -> null
        }
    }

    private fun insert(whole: Value, indices: IntArray, part: Value): Value {
        var type = whole.type
        var at = 0
        for (index in indices) {
            val (inner, start) = type.part(index)
            type = inner
            at += start
        }
        val cells = whole.cells.copyOf()
        part.cells.copyInto(cells, at)
        return Value(whole.type, cells)
    }

    /** An element of [vector], in a variable of its own, since its numbers need not lie side by side. */
    private fun element(vector: Value, index: Value): Pointer {
        val variable = memory.variable("", vector.type, Storage.FUNCTION)
        val whole = Pointer(variable, vector.type, variable.base)
        memory.store(whole, vector)
        return memory.access(whole, listOf(index)) { null }
    }
}
