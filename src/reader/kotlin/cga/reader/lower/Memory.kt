package cga.reader.lower

import cga.reader.shader.Operation.INDEX
import cga.reader.shader.Operation.LOAD
import cga.reader.shader.Operation.MOVE
import cga.reader.shader.Operation.OFFSET
import cga.reader.shader.Operation.STORE
import cga.reader.shader.Source
import cga.reader.spirv.Storage
import cga.reader.spirv.Type

/** Loads and stores. Within a block what was stored or loaded last is known, and nothing needs to be read again. */
internal class Memory(private val emitter: Emitter) {
    private val known = HashMap<Int, Int>()

    /** Another block begins, which more than one way may lead to. */
    fun forget() {
        known.clear()
    }

    fun load(pointer: Pointer): Value {
        val place = pointer.base until pointer.base + pointer.type.cells
        val cells = when {
            pointer.dynamic >= 0 -> place.map { emitter.op(LOAD, pointer.dynamic, it) }
            pointer.variable.isReadOnly -> place.toList()
            else -> place.map { cell -> known.getOrPut(cell) { emitter.op(MOVE, cell) } }
        }
        return Value(pointer.type, cells.toIntArray())
    }

    fun store(pointer: Pointer, value: Value) {
        for ((i, cell) in value.cells.withIndex()) {
            val place = pointer.base + i
            if (pointer.dynamic < 0) {
                emitter.emit(MOVE, place, cell)
                known[place] = cell
            } else {
                emitter.emit(STORE, 0, pointer.dynamic, cell, place)
            }
        }
        if (pointer.dynamic >= 0) known.keys.removeAll(pointer.variable.cells.toSet())
        // Not the copies that the compiler makes for the parameters of functions.
        if (pointer.name.isNotEmpty() && pointer.name != "param") emitter.result(value.cells, pointer.name)
    }

    /** The part of what [pointer] points to that [indices] select; [constant] tells the number of an index that is constant, else null. */
    fun access(pointer: Pointer, indices: List<Value>, constant: (Value) -> Int?): Pointer =
        indices.fold(pointer) { at, index ->
            val number = constant(index)
            if (number != null) {
                val (part, start) = at.type.part(number)
                Pointer(at.variable, part, at.base + start, at.dynamic, at.path + path(at.type, number))
            } else {
                val (part, count) = at.type.parts()
                val offset = emitter.op(INDEX, index.cell, part.cells, count)
                val sum = if (at.dynamic < 0) offset else emitter.op(OFFSET, at.dynamic, offset)
                Pointer(at.variable, part, at.base, sum, at.path + "[]")
            }
        }

    /** A variable in new cells. */
    fun variable(name: String, type: Type, storage: Storage): Variable {
        val base = emitter.initial.size
        repeat(type.cells) { emitter.cell(Source.Unset(name)) }
        val isReadOnly = storage == Storage.INPUT || storage == Storage.UNIFORM || storage == Storage.UNIFORM_CONSTANT
        return Variable(name, base, type, isReadOnly).also { emitter.addVariable(it.cells) }
    }

    private fun path(type: Type, index: Int) = when (type) {
        is Type.Struct -> "." + type.members[index].name
        is Type.Vector -> "." + "xyzw"[index]
        else -> "[$index]"
    }
}
