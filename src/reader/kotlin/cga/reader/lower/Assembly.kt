package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.shader.Result
import cga.reader.shader.Results
import cga.reader.shader.Shader
import cga.reader.shader.Source
import cga.reader.shader.Stage
import cga.reader.shader.SwitchTable

/** Puts what an [Emitter] has into arrays, without the moves that nobody reads. */
internal class Assembly(
    private val emitter: Emitter,
    private val interfaces: Interface,
) {
    private val code = emitter.code
    private val isKept = BooleanArray(code.size) { true }

    fun shader(stage: Stage): Shader {
        do {
            val isDone = !dropMoves()
        } while (!isDone)
        dropJumps()
        val places = places()
        val targets = emitter.labels.map { if (it < 0) places[code.size - 1] else places[it] }
        val kept = code.filterIndexed { i, _ -> isKept[i] }
        val indices = kept.withIndex().associate { it.value to it.index }
        return Shader(
            stage,
            interfaces.uniforms,
            interfaces.inputs,
            interfaces.outputs,
            kept.flatMap { words(it, targets) }.toIntArray(),
            IntArray(kept.size) { kept[it].line },
            Array(kept.size) { kept[it].origin },
            IntArray(kept.size) { at -> kept[at].guard?.let(indices::get) ?: -1 },
            BooleanArray(kept.size) { kept[it].isLoopTest },
            emitter.initial.toDoubleArray(),
            emitter.sources.toTypedArray<Source?>(),
            emitter.textures,
            emitter.switches.map { table -> SwitchTable(table.targets.mapValues { targets[it.value] }, targets[table.default]) },
            results(places, kept.size, indices),
        )
    }

    private fun words(instruction: Emitted, targets: List<Int>): List<Int> {
        val operation = instruction.operation
        val isBranch = operation == Operation.BRANCH
        return listOf(
            operation.ordinal,
            instruction.target,
            if (operation == Operation.JUMP) targets[instruction.a] else instruction.a,
            if (isBranch) targets[instruction.b] else instruction.b,
            if (isBranch) targets[instruction.c] else instruction.c,
        )
    }

    /** Where each instruction comes to lie, and the end. */
    private fun places(): IntArray {
        val places = IntArray(code.size + 1)
        for (i in code.indices) places[i + 1] = places[i] + if (isKept[i]) 1 else 0
        return places
    }

    private fun results(places: IntArray, count: Int, indices: Map<Emitted, Int>): Results {
        val byPlace = emitter.results.groupBy { places[it.before] }
        val starts = IntArray(count + 1)
        for (at in 0 until count) starts[at + 1] = starts[at] + byPlace[at].orEmpty().size
        val all = (0 until count).flatMap { byPlace[it].orEmpty() }.map { result ->
            Result(result.cells, result.line, result.name, result.origin, result.guard?.let(indices::get) ?: -1)
        }
        return Results(starts, all.toTypedArray())
    }

    /** Drops the jumps to the next instruction, but for those that results wait at: what comes next may be reached otherwise. */
    private fun dropJumps() {
        val places = places()
        val waiting = emitter.results.map { places[it.before] }.toSet()
        for ((i, instruction) in code.withIndex()) {
            if (!isKept[i] || instruction.operation != Operation.JUMP || places[i] in waiting) continue
            if (places[emitter.labels[instruction.a]] == places[i] + 1) isKept[i] = false
        }
    }

    /** Drops the moves to cells that nothing reads; whether there were any. */
    private fun dropMoves(): Boolean {
        val isRead = BooleanArray(emitter.initial.size)
        for (slot in interfaces.outputs) isRead.fill(true, slot.cell, slot.cell + slot.size)
        for (result in emitter.results) for (cell in result.cells) isRead[cell] = true
        for ((i, instruction) in code.withIndex()) if (isKept[i]) markRead(instruction, isRead)
        val dropped = code.indices.filter { isKept[it] && code[it].operation == Operation.MOVE && !isRead[code[it].target] }
        for (i in dropped) isKept[i] = false
        return dropped.isNotEmpty()
    }

    private fun markRead(instruction: Emitted, isRead: BooleanArray) {
        when (instruction.operation) {
            Operation.TEXTURE, Operation.TEXTURE_SIZE -> for (cell in emitter.textures[instruction.a].operands) isRead[cell] = true
            Operation.LOAD -> {
                isRead[instruction.a] = true
                // The part of the array begins at b; how far it goes is known to its variable.
                for (cell in emitter.variableAt(instruction.b)) isRead[cell] = true
            }
            else -> {
                val cells = intArrayOf(instruction.a, instruction.b, instruction.c)
                for (k in 0 until instruction.operation.operands) isRead[cells[k]] = true
            }
        }
    }
}
