package cga.reader.lower

import cga.reader.shader.Source
import cga.reader.spirv.Module
import cga.reader.spirv.Type

/** What the ids of a module stand for where a function is put: those of the function, and those of the module. */
internal class Scope(
    val module: Module,
    val emitter: Emitter,
    private val globals: Scope? = null,
) {
    private val values = HashMap<Int, Value>()
    private val pointers = HashMap<Int, Pointer>()

    fun type(id: Int): Type = module.types.getValue(id)

    fun value(id: Int): Value =
        values[id] ?: globals?.values?.get(id) ?: module.constants.getValue(id).let { constant ->
            Value(constant.type, IntArray(constant.cells.size) { emitter.constant(constant.cells[it]) })
        }

    fun pointer(id: Int): Pointer = pointers[id] ?: globals?.pointers.orEmpty().getValue(id)

    fun isPointer(id: Int): Boolean = id in pointers || id in globals?.pointers.orEmpty()

    operator fun set(id: Int, value: Value) {
        values[id] = value
    }

    operator fun set(id: Int, pointer: Pointer) {
        pointers[id] = pointer
    }

    /** The number that [value] is whatever runs, or null. */
    fun constant(value: Value): Int? = (emitter.sources[value.cell] as? Source.Constant)?.value?.toInt()
}
