package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.shader.Operation.ADD
import cga.reader.shader.Shader
import cga.reader.shader.Stage
import cga.reader.spirv.Block
import cga.reader.spirv.Function
import cga.reader.spirv.Instruction
import cga.reader.spirv.Module
import cga.reader.spirv.Op
import cga.reader.spirv.Storage
import cga.reader.spirv.Type
import cga.reader.spirv.UnreadableException
import cga.reader.spirv.naming

/** Makes a [Shader] of a module: functions put where they are called, vectors taken apart, what only moves numbers gone. */
internal class Lowering(private val module: Module) {
    private val emitter = Emitter()
    private val memory = Memory(emitter)
    private val arithmetic = Arithmetic(emitter)
    private val algebra = Algebra(emitter)
    private val composites = Composites(emitter, memory)
    private val textures = Textures(emitter)
    private val standard = StandardFunctions(emitter, arithmetic, algebra)
    private val globals = Scope(module, emitter)
    private val guardsOf = HashMap<Int, Map<Int, Int>>()

    fun lower(stage: Stage): Shader {
        val interfaces = Interface(emitter)
        for (global in module.variables) {
            val variable = interfaces.add(global, memory)
            val pointer = Pointer(variable, global.type, variable.base)
            globals[global.id] = pointer
            if (global.initializer != 0) initialize(pointer, globals.value(global.initializer))
        }
        for (instruction in module.computed) naming(instruction) { value(instruction, globals) }
        call(module.functions.getValue(module.entry), emptyList(), globals, 0)
        emitter.emit(Operation.END, 0)
        return Assembly(emitter, interfaces).shader(stage)
    }

    /** A uniform's initial value is there before anything runs, that of others is assigned. */
    private fun initialize(pointer: Pointer, value: Value) {
        if (!pointer.variable.isReadOnly) return memory.store(pointer, value)
        for ((i, cell) in value.cells.withIndex()) emitter.initial[pointer.base + i] = emitter.initial[cell]
    }

    /** [function] with [arguments], each a [Value] or a [Pointer]; what it returns, or null. */
    private fun call(function: Function, arguments: List<Any>, caller: Scope, depth: Int): Value? {
        if (depth > MAX_DEPTH) throw UnreadableException("functions call each other more than $MAX_DEPTH deep, or themselves")
        val scope = Scope(module, emitter, globals)
        for ((id, argument) in function.parameters.zip(arguments)) {
            if (argument is Pointer) scope[id] = argument else scope[id] = argument as Value
            val whole = argument as? Value ?: (argument as Pointer).takeIf { it.type !is Type.Image && it.dynamic < 0 }?.let(memory::load)
            module.names[id]?.let { name -> whole?.let { emitter.result(it.cells, name) } }
        }
        return Inlined(function, scope, depth).lower()
    }

    /** A function where it is called. */
    private inner class Inlined(
        private val function: Function,
        private val scope: Scope,
        private val depth: Int,
    ) {
        private val labels = function.blocks.associate { it.label to emitter.newLabel() }
        private val end = emitter.newLabel()
        private val outerGuard = emitter.guard
        private val guardedBy = guardsOf.getOrPut(function.id) { guards(function) }
        private val blocks = function.blocks.associateBy { it.label }
        private val branches = HashMap<Int, Emitted>()
        private val phis = HashMap<Int, IntArray>()

        /** Where more than one place returns, each puts the result here. */
        private val returns = function.blocks.count { it.instructions.last().op in RETURNS }
        private var result: Value? = null

        fun lower(): Value? {
            for (block in function.blocks) {
                if (block !== function.blocks.first()) memory.forget()
                emitter.place(labels.getValue(block.label))
                emitter.guard = guardedBy[block.label]?.let(branches::get) ?: outerGuard
                for (instruction in block.instructions) {
                    emitter.line = instruction.line
                    emitter.origin = instruction.op.name.lowercase()
                    naming(instruction) { instruction(instruction, block) }
                }
            }
            if (function.blocks.size > 1) memory.forget()
            emitter.place(end)
            emitter.guard = outerGuard
            return result
        }

        private fun instruction(instruction: Instruction, block: Block) {
            val operands = instruction.operands
            when (instruction.op) {
                Op.SELECTION_MERGE, Op.LOOP_MERGE -> Unit
                Op.VARIABLE -> {
                    val type = scope.type(instruction.type) as Type.Pointer
                    val variable = memory.variable(module.names[instruction.id].orEmpty(), type.target, Storage.FUNCTION)
                    scope[instruction.id] = Pointer(variable, type.target, variable.base)
                    operands.getOrNull(1)?.let { memory.store(scope.pointer(instruction.id), scope.value(it)) }
                }
                Op.PHI -> {
                    val type = scope.type(instruction.type)
                    val shadow = shadow(instruction)
                    scope[instruction.id] = Value(type, shadow.map { emitter.op(Operation.MOVE, it) }.toIntArray())
                }
                Op.FUNCTION_CALL -> {
                    val callee = module.functions.getValue(operands[0])
                    val arguments = instruction.from(1).map { if (scope.isPointer(it)) scope.pointer(it) else scope.value(it) }
                    val line = emitter.line
                    call(callee, arguments, scope, depth + 1)?.let { scope[instruction.id] = it }
                    emitter.line = line
                }
                else -> if (instruction.op.isTerminator) leave(instruction, block) else value(instruction, scope)
            }
        }

        /** The cells that the blocks before leave a phi's value in. */
        private fun shadow(phi: Instruction) =
            phis.getOrPut(phi.id) { IntArray(scope.type(phi.type).cells) { emitter.cell() } }

        private fun leave(instruction: Instruction, block: Block) {
            for (next in successors(block)) passPhis(block.label, next)
            val operands = instruction.operands

            fun label(i: Int) = labels.getValue(operands[i])
            when (instruction.op) {
                Op.BRANCH -> emitter.jump(label(0))
                Op.BRANCH_CONDITIONAL -> {
                    val branch = emitter.branch(scope.value(operands[0]).cell, label(1), label(2))
                    branch.isLoopTest = block.instructions.none { it.op == Op.SELECTION_MERGE }
                    branches[block.label] = branch
                }
                Op.SWITCH -> {
                    val targets = (2 until operands.size step 2).associate { operands[it] to label(it + 1) }
                    branches[block.label] = emitter.switch(scope.value(operands[0]).cell, targets, label(1))
                }
                Op.KILL -> emitter.emit(Operation.DISCARD, 0)
                Op.RETURN_VALUE -> returnValue(scope.value(operands[0]))
                else -> emitter.jump(end)
            }
        }

        private fun passPhis(from: Int, to: Int) {
            for (phi in blocks.getValue(to).instructions.takeWhile { it.op == Op.PHI }) {
                val value = (0 until phi.operands.size step 2).find { phi.operands[it + 1] == from } ?: continue
                val cells = scope.value(phi.operands[value]).cells
                for ((i, target) in shadow(phi).withIndex()) emitter.emit(Operation.MOVE, target, cells[i])
            }
        }

        private fun returnValue(value: Value) {
            if (returns == 1) {
                result = value
            } else {
                val place = result ?: Value(value.type, IntArray(value.cells.size) { emitter.cell() }).also { result = it }
                for ((i, target) in place.cells.withIndex()) emitter.emit(Operation.MOVE, target, value.cells[i])
            }
            emitter.jump(end)
        }
    }

    /** An instruction that neither calls nor goes on elsewhere. */
    private fun value(instruction: Instruction, scope: Scope) {
        val operands = instruction.operands
        when (instruction.op) {
            Op.LOAD -> scope[instruction.id] = memory.load(scope.pointer(operands[0]))
            Op.STORE -> memory.store(scope.pointer(operands[0]), scope.value(operands[1]))
            Op.COPY_MEMORY -> memory.store(scope.pointer(operands[0]), memory.load(scope.pointer(operands[1])))
            Op.ACCESS_CHAIN, Op.IN_BOUNDS_ACCESS_CHAIN ->
                scope[instruction.id] = memory.access(scope.pointer(operands[0]), instruction.from(1).map(scope::value), scope::constant)
            else -> {
                val value = computed(instruction, scope)
                scope[instruction.id] = value
                if (value.cells.size > 1) emitter.result(value.cells)
            }
        }
    }

    private fun computed(instruction: Instruction, scope: Scope): Value =
        when (instruction.op) {
            Op.EXT_INST -> standard.lower(instruction, scope)
            // |dFdx(p)| + |dFdy(p)|
            Op.FWIDTH -> scope.type(instruction.type).let { type ->
                val p = listOf(scope.value(instruction.operands[0]))
                val parts = listOf(Operation.DPDX, Operation.DPDY).map {
                    arithmetic.each(type, Operation.ABS, listOf(arithmetic.each(type, it, p)))
                }
                arithmetic.each(type, ADD, parts)
            }
            else ->
                composites.lower(instruction, scope) ?: arithmetic.lower(instruction, scope) ?: algebra.lower(instruction, scope)
                    ?: textures.lower(instruction, scope) ?: throw UnreadableException("SPIR-V's ${instruction.op} cannot be run")
        }

    private companion object {
        const val MAX_DEPTH = 64
        val RETURNS = setOf(Op.RETURN, Op.RETURN_VALUE)
    }
}
