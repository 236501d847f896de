package cga.reader.lower

import cga.reader.spirv.Type
import cga.reader.spirv.UnreadableException

/** A value: its type, and the cells of its numbers. What only rearranges numbers rearranges cells and costs nothing when it runs. */
internal class Value(
    val type: Type,
    val cells: IntArray,
) {
    constructor(type: Type, cell: Int) : this(type, intArrayOf(cell))

    /** The only number. */
    val cell: Int get() = cells.single()

    /** The part that [index] selects. */
    fun part(index: Int): Value {
        val (part, start) = type.part(index)
        return Value(part, cells.copyOfRange(start, start + part.cells))
    }

    /** All parts: the columns of a matrix, the components of a vector. */
    fun parts(): List<Value> = List(type.parts().second, ::part)
}

/** A variable: cells one after the other. What is never written can be read where it stands. */
internal class Variable(
    val name: String,
    val base: Int,
    val type: Type,
    val isReadOnly: Boolean,
) {
    val cells: IntRange get() = base until base + type.cells
}

/**
 * A variable or a part of it.
 *
 * @param base where that part would begin were [dynamic] 0.
 * @param dynamic the cell with what is added to it when it runs, or -1.
 * @param path what is selected of the variable, as GLSL writes it.
 */
internal class Pointer(
    val variable: Variable,
    val type: Type,
    val base: Int,
    val dynamic: Int = -1,
    val path: String = "",
) {
    val name: String get() = variable.name + path
}

/** What a vector or a scalar is made of. */
internal val Type.componentType: Type
    get() = when (this) {
        is Type.Vector -> component
        is Type.Matrix -> column.component
        is Type.Bool, is Type.Integer, is Type.Float -> this
        else -> throw UnreadableException("arithmetic with ${this::class.simpleName}")
    }
