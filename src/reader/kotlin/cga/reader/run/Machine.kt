package cga.reader.run

import cga.reader.shader.Kind
import cga.reader.shader.Operation
import cga.reader.shader.Shader
import cga.reader.shader.Slot
import cga.reader.tape.Tape
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.sqrt

/**
 * Runs a [shader], in double precision: as often as wanted, one invocation after the other. Uniforms and inputs keep what was set; all
 * else begins anew each time. Constants are the floats that GLSL makes of what is written.
 *
 * Where GLSL leaves open what happens, the result is some number and never an exception: an index beyond an array is the nearest one
 * within, an integer divided by 0 is 0, a variable without a value is 0, a power of a negative number is NaN, the larger or smaller of a
 * number and NaN is the number. Derivatives of a lone invocation are 0; see [Quad].
 */
public class Machine(public val shader: Shader) {
    private val given = shader.initial.copyOf()
    internal val cells = shader.initial.copyOf()
    private val code = shader.code
    private val samplers = arrayOfNulls<Sampler>(shader.samplers.size)
    private val look = Looking(cells)
    private var tape: Tape? = null
    private var pc = 0
    private var steps = 0L
    private var stepLimit = 0L

    /** Whether to halt where invocations of a quad exchange numbers. */
    internal var isInQuad = false

    /** Sets a uniform or an input; a matrix column by column, a boolean as 0 or 1. */
    public operator fun set(slot: Slot, numbers: DoubleArray) {
        require(numbers.size == slot.size && slot.kind != Kind.SAMPLER) { "${slot.name} takes ${slot.size} numbers, not ${numbers.size}" }
        numbers.copyInto(given, slot.cell)
    }

    public operator fun set(name: String, numbers: DoubleArray) {
        set(slot(name), numbers)
    }

    /** Sets the texture of a sampler. */
    public operator fun set(slot: Slot, sampler: Sampler) {
        val handle = shader.samplers.indexOf(slot)
        require(handle >= 0) { "${slot.name} is no sampler" }
        samplers[handle] = sampler
    }

    /** The numbers of an output after a run, or of a uniform or input. */
    public operator fun get(slot: Slot): DoubleArray = cells.copyOfRange(slot.cell, slot.cell + slot.size)

    public operator fun get(name: String): DoubleArray = get(slot(name))

    private fun slot(name: String) = requireNotNull(shader.slot(name)) { "the shader has no uniform, input or output $name" }

    /** Runs it to its end, or for [steps] operations. With a [tape] everything that it does is on it afterwards. */
    public fun run(tape: Tape? = null, steps: Long = MAX_STEPS): Outcome {
        begin(tape, steps)
        return checkNotNull(goOn()) { "only in a quad it halts" }
    }

    internal fun begin(tape: Tape?, steps: Long) {
        require(tape == null || tape.shader === shader) { "the tape is another shader's" }
        given.copyInto(cells)
        tape?.begin(cells)
        this.tape = tape
        this.steps = 0
        stepLimit = steps
        pc = 0
    }

    /** Where it has halted for its neighbours: the instruction, and the cells that they look at. */
    internal val haltedAt: Int get() = pc
    internal val exchanged: IntArray
        get() = code[pc * Shader.STRIDE + 2].let { if (isTexture(pc)) shader.textures[it].coordinates else intArrayOf(it) }
    internal val isAlongX: Boolean get() = shader.operation(pc) == Operation.DPDX

    private fun isTexture(at: Int) = shader.operation(at) == Operation.TEXTURE

    /** Goes on after a halt, with how the numbers differ along x and y. */
    internal fun resume(gradientX: DoubleArray, gradientY: DoubleArray): Outcome? {
        val at = pc * Shader.STRIDE
        if (isTexture(pc)) {
            if (!texture(code[at + 1], gradientX, gradientY)) return Outcome.NO_SAMPLER
        } else {
            put(pc, code[at + 1], (if (isAlongX) gradientX else gradientY)[0], code[at + 2])
        }
        pc++
        return goOn()
    }

    private fun put(pc: Int, target: Int, value: Double, a: Int) {
        cells[target] = value
        tape?.let { it.references[target] = it.add(pc, value, a, a, a) }
    }

    private fun texture(target: Int, gradientX: DoubleArray, gradientY: DoubleArray): Boolean {
        val call = shader.textures[code[pc * Shader.STRIDE + 2]]
        val sampler = samplers.getOrNull(cells[call.sampler].toInt()) ?: return false
        val isSize = shader.operation(pc) == Operation.TEXTURE_SIZE
        val numbers = if (isSize) look.size(call, sampler) else look.sample(call, sampler, gradientX, gradientY)
        for (i in 0 until call.results) {
            cells[target + i] = numbers[i]
            tape?.let { it.references[target + i] = it.add(pc, numbers[i], call.operands) }
        }
        return true
    }

    /** Runs on; null where it halts for its neighbours in a quad. */
    internal fun goOn(): Outcome? {
        val code = code
        val cells = cells
        val tape = tape
        var pc = pc
        var blockStart = pc
        while (true) {
            val at = pc * Shader.STRIDE
            val target = code[at + 1]
            val a = code[at + 2]
            val b = code[at + 3]
            val c = code[at + 4]
            tape?.addResults(pc)
            val value = when (val operation = Shader.OPERATIONS[code[at]]) {
                Operation.ADD -> cells[a] + cells[b]
                Operation.SUB -> cells[a] - cells[b]
                Operation.MUL -> cells[a] * cells[b]
                Operation.DIV -> cells[a] / cells[b]
                Operation.NEG -> -cells[a]
                Operation.ABS -> abs(cells[a])
                Operation.MIN -> smaller(cells[a], cells[b])
                Operation.MAX -> larger(cells[a], cells[b])
                Operation.SQRT -> sqrt(cells[a])
                Operation.INVERSE_SQRT -> 1 / sqrt(cells[a])
                Operation.POW -> power(cells[a], cells[b])
                Operation.EQUAL -> truth(cells[a] == cells[b])
                Operation.NOT_EQUAL -> truth(cells[a] != cells[b])
                Operation.LESS -> truth(cells[a] < cells[b])
                Operation.LESS_EQUAL -> truth(cells[a] <= cells[b])
                Operation.AND -> cells[a] * cells[b]
                Operation.OR -> max(cells[a], cells[b])
                Operation.NOT -> 1 - cells[a]
                Operation.SELECT -> if (cells[a] != 0.0) cells[b] else cells[c]
                Operation.INT_ADD -> wrapped(cells[a].toLong() + cells[b].toLong(), c != 0)
                Operation.MOVE -> {
                    cells[target] = cells[a]
                    if (tape != null) tape.references[target] = tape.references[a]
                    pc++
                    continue
                }
                Operation.INDEX -> {
                    cells[target] = place(cells[a], b, c)
                    pc++
                    continue
                }
                Operation.OFFSET -> {
                    cells[target] = cells[a] + cells[b]
                    pc++
                    continue
                }
                Operation.LOAD -> {
                    val from = b + cells[a].toInt()
                    cells[target] = cells[from]
                    if (tape != null) tape.references[target] = tape.references[from]
                    pc++
                    continue
                }
                Operation.STORE -> {
                    val to = c + cells[a].toInt()
                    cells[to] = cells[b]
                    if (tape != null) tape.references[to] = tape.references[b]
                    pc++
                    continue
                }
                Operation.JUMP, Operation.BRANCH, Operation.SWITCH -> {
                    steps += pc + 1 - blockStart
                    if (steps > stepLimit) return Outcome.TOO_LONG
                    if (tape != null && operation != Operation.JUMP) tape.add(pc, cells[a], a, a, a)
                    pc = next(operation, a, b, c)
                    blockStart = pc
                    continue
                }
                Operation.TEXTURE, Operation.TEXTURE_SIZE -> {
                    this.pc = pc
                    if (isInQuad && operation == Operation.TEXTURE && shader.textures[a].isImplicit) return halt(pc, blockStart)
                    if (!texture(target, NONE, NONE)) return Outcome.NO_SAMPLER
                    pc++
                    continue
                }
                Operation.DPDX, Operation.DPDY -> if (isInQuad) return halt(pc, blockStart) else 0.0
                Operation.DISCARD -> return Outcome.DISCARDED
                Operation.END -> return Outcome.DONE
                else -> rare(operation, cells[a], cells[b], c != 0)
            }
            cells[target] = value
            if (tape != null) tape.references[target] = tape.add(pc, value, a, b, c)
            pc++
        }
    }

    private fun halt(at: Int, blockStart: Int): Outcome? {
        pc = at
        steps += at + 1 - blockStart
        return null
    }

    private fun next(operation: Operation, a: Int, b: Int, c: Int): Int =
        when (operation) {
            Operation.JUMP -> a
            Operation.BRANCH -> if (cells[a] != 0.0) b else c
            else -> shader.switches[b].let { it.targets[cells[a].toLong().toInt()] ?: it.default }
        }

    public companion object {
        /** What a run may take where nothing else is said: a few hundredths of a second. */
        public const val MAX_STEPS: Long = 4_000_000
        private val NONE = DoubleArray(0)
    }
}
