package cga.reader.lower

import cga.reader.shader.Kind
import cga.reader.shader.Slot
import cga.reader.shader.Source
import cga.reader.spirv.GlobalVariable
import cga.reader.spirv.Storage
import cga.reader.spirv.Type

/** The uniforms, inputs and outputs of a shader, by the names of OpenGL, and the variables that they are parts of. */
internal class Interface(private val emitter: Emitter) {
    val uniforms = ArrayList<Slot>()
    val inputs = ArrayList<Slot>()
    val outputs = ArrayList<Slot>()

    fun add(global: GlobalVariable, memory: Memory): Variable {
        val variable = memory.variable(global.builtIn?.glsl ?: global.name, global.type, global.storage)
        val slots = when (global.storage) {
            Storage.UNIFORM, Storage.UNIFORM_CONSTANT -> uniforms
            Storage.INPUT -> inputs
            Storage.OUTPUT -> outputs
            else -> return variable
        }
        addSlots(slots, global, global.builtIn?.glsl ?: root(global), global.type, variable.base)
        return variable
    }

    /** Members of a block are called after the block, or by themselves where its variable has no name. */
    private fun root(global: GlobalVariable): String {
        val block = generateSequence(global.type) { (it as? Type.Array)?.element }.last()
        return if (block is Type.Struct && block.isBlock && global.name.isNotEmpty()) block.name else global.name
    }

    private fun addSlots(slots: MutableList<Slot>, global: GlobalVariable, name: String, type: Type, cell: Int) {
        when (type) {
            is Type.Struct -> {
                var at = cell
                for (member in type.members) {
                    val memberName = member.builtIn?.glsl ?: if (name.isEmpty()) member.name else "$name.${member.name}"
                    addSlots(slots, global, memberName, member.type, at)
                    at += member.type.cells
                }
            }
            is Type.Array -> repeat(type.count) { addSlots(slots, global, "$name[$it]", type.element, cell + it * type.element.cells) }
            else -> addSlot(slots, global, name, type, cell)
        }
    }

    private fun addSlot(slots: MutableList<Slot>, global: GlobalVariable, name: String, type: Type, cell: Int) {
        val columns = if (type is Type.Matrix) type.count else 1
        val slot = Slot(name, kind(type), columns, type.cells / columns, global.location, cell)
        slots += slot
        for (i in 0 until type.cells) {
            when (global.storage) {
                Storage.INPUT -> emitter.sources[cell + i] = Source.Input(slot, i)
                Storage.OUTPUT -> Unit
                else -> emitter.sources[cell + i] = Source.Uniform(slot, i)
            }
        }
        if (slot.kind == Kind.SAMPLER) emitter.initial[cell] = uniforms.count { it.kind == Kind.SAMPLER } - 1.0
    }

    private fun kind(type: Type): Kind {
        if (type is Type.Image) return Kind.SAMPLER
        return when (val component = type.componentType) {
            is Type.Integer -> if (component.isSigned) Kind.INT else Kind.UINT
            Type.Bool -> Kind.BOOL
            else -> Kind.FLOAT
        }
    }
}
