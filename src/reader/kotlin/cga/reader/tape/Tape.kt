package cga.reader.tape

import cga.reader.shader.Operation
import cga.reader.shader.Shader
import cga.reader.shader.Source

/**
 * What an invocation of a shader computed: every operation that ran, in the order in which they ran.
 *
 * Operations are on single numbers: `dot(a, b)` of two `vec3` is three products and two sums, on one line and of one [origin]. A *reference* says where a
 * number comes from: from 0 on it is an *entry*, an operation on this tape; below 0 it is a source, which [source] tells: a constant, a component of a
 * uniform or of an input, or a variable that was never assigned. What moves numbers without changing them (variables, parameters, swizzles, constructors,
 * elements of arrays) leaves no entry: references go through it. A computed index is no operand of what it picks.
 *
 * A tape is filled by one run and can be used again for the next one; then everything on it is replaced.
 */
public class Tape(internal val shader: Shader) {
    /** How many operations ran. */
    public var size: Int = 0
        private set
    private var at = IntArray(FIRST_SIZE)
    private var values = DoubleArray(FIRST_SIZE)
    private var guards = IntArray(FIRST_SIZE)
    private var rounds = IntArray(FIRST_SIZE)
    private var starts = IntArray(FIRST_SIZE + 1)
    private var operands = IntArray(2 * FIRST_SIZE)
    private var sources = DoubleArray(0)

    /** What each cell holds now, as a reference. */
    internal val references = IntArray(shader.initial.size)

    /** The last entry of each branch, and how often each loop's test ran. */
    private val branches = IntArray(shader.size)
    private val tests = IntArray(shader.size)
    private val heldResults = ArrayList<TapeResult>()

    /** Vectors and matrices as a whole, and what was assigned to variables and given to parameters, in order. */
    public val results: List<TapeResult> get() = heldResults

    /** What entry [entry] did. */
    public fun operation(entry: Int): Operation = shader.operation(at[entry])

    /** The line of the GLSL that entry [entry] was made from, 0 where it is not known. */
    public fun line(entry: Int): Int = shader.line(at[entry])

    /** What entry [entry] is a part of: a function of GLSL (`normalize`), or an instruction of SPIR-V (`f_mul`, `matrix_times_vector`). */
    public fun origin(entry: Int): String = shader.origin(at[entry])

    /**
     * The number of the operation in the shader. Entries of the same place and [round], on one tape or on those of several runs, are the same quantity:
     * so are values at several points to be compared.
     */
    public fun place(entry: Int): Int = at[entry]

    /** In which round of the innermost loop around it entry [entry] ran, counted over all times that the loop ran; 0 outside of loops, or where they have no test. */
    public fun round(entry: Int): Int = rounds[entry]

    /** How many operands entry [entry] has. */
    public fun operandCount(entry: Int): Int = starts[entry + 1] - starts[entry]

    /** Operand [index] of entry [entry], a reference. */
    public fun operand(entry: Int, index: Int): Int = operands[starts[entry] + index]

    /** The entry of the innermost branch or loop test around entry [entry], or -1. Early returns count for nothing. */
    public fun guard(entry: Int): Int = guards[entry]

    /** The number that [reference] stands for. */
    public fun value(reference: Int): Double = if (reference >= 0) values[reference] else sources[reference.inv()]

    /** Where [reference], below 0, comes from. */
    public fun source(reference: Int): Source = shader.source(reference.inv()) ?: Source.Unset("")

    /** The references of an output or another variable's numbers, as they are now: at the end, after a run. */
    public fun references(name: String): IntArray {
        val slot = requireNotNull(shader.slot(name)) { "the shader has no uniform, input or output $name" }
        return references.copyOfRange(slot.cell, slot.cell + slot.size)
    }

    internal fun begin(cells: DoubleArray) {
        size = 0
        heldResults.clear()
        sources = cells.copyInto(if (sources.size == cells.size) sources else DoubleArray(cells.size))
        for (cell in references.indices) references[cell] = cell.inv()
        branches.fill(-1)
        tests.fill(0)
    }

    /** The results that are known before instruction [pc] runs. */
    internal fun addResults(pc: Int) {
        val known = shader.results
        for (i in known.starts[pc] until known.starts[pc + 1]) {
            val result = known.all[i]
            val cells = result.cells
            val guard = if (result.guard < 0) -1 else branches[result.guard]
            val references = IntArray(cells.size) { references[cells[it]] }
            heldResults += TapeResult(result.name, result.origin, result.line, i, if (guard < 0) 0 else rounds[guard], size, references)
        }
    }

    /** Adds what instruction [pc] made of the cells [a], [b] and [c], as far as it has so many operands; its entry. */
    internal fun add(pc: Int, value: Double, a: Int, b: Int, c: Int): Int {
        val entry = open(pc, value)
        var end = starts[entry]
        val count = shader.operation(pc).operands
        if (end + 3 > operands.size) operands = operands.copyOf(2 * operands.size)
        operands[end++] = references[a]
        if (count > 1) operands[end++] = references[b]
        if (count > 2) operands[end++] = references[c]
        starts[entry + 1] = end
        return entry
    }

    /** Adds a number that a texture gave for what is in [cells]. */
    internal fun add(pc: Int, value: Double, cells: IntArray): Int {
        val entry = open(pc, value)
        val start = starts[entry]
        while (start + cells.size > operands.size) operands = operands.copyOf(2 * operands.size)
        for (i in cells.indices) operands[start + i] = references[cells[i]]
        starts[entry + 1] = start + cells.size
        return entry
    }

    private fun open(pc: Int, value: Double): Int {
        if (size == at.size) grow()
        val entry = size++
        at[entry] = pc
        values[entry] = value
        val guard = shader.guards[pc]
        val guardEntry = if (guard < 0) -1 else branches[guard]
        guards[entry] = guardEntry
        rounds[entry] = if (shader.loopTests[pc]) {
            tests[pc]++
        } else if (guardEntry < 0) {
            0
        } else {
            rounds[guardEntry]
        }
        branches[pc] = entry
        return entry
    }

    private fun grow() {
        val size = 2 * size
        at = at.copyOf(size)
        values = values.copyOf(size)
        guards = guards.copyOf(size)
        rounds = rounds.copyOf(size)
        starts = starts.copyOf(size + 1)
    }

    private companion object {
        const val FIRST_SIZE = 4096
    }
}

/**
 * Numbers that belong together: a vector, a matrix column by column, or what a variable or a parameter got.
 *
 * @property name of the variable or parameter as GLSL writes it (`spec`, `light.color`), null for what has none.
 * @property origin what made it.
 * @property place with [round], what is the same for the same quantity in several runs, as [Tape.place] and [Tape.round] are.
 * @property end how many entries the tape had then.
 * @property references one a number.
 */
public class TapeResult internal constructor(
    public val name: String?,
    public val origin: String,
    public val line: Int,
    public val place: Int,
    public val round: Int,
    public val end: Int,
    public val references: IntArray,
)
