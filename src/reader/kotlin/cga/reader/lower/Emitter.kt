package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.shader.Operation.BRANCH
import cga.reader.shader.Operation.JUMP
import cga.reader.shader.Operation.SWITCH
import cga.reader.shader.Source
import cga.reader.shader.SwitchTable
import cga.reader.shader.TextureCall
import cga.reader.spirv.UnreadableException
import java.util.TreeMap

/** An instruction whose targets are labels still, and what [line], [origin] and [guard] the shader knows of it. */
internal class Emitted(
    val operation: Operation,
    val target: Int,
    val a: Int,
    val b: Int,
    val c: Int,
    val line: Int,
    val origin: String,
    val guard: Emitted?,
) {
    /** Whether it decides if a loop goes on. */
    var isLoopTest: Boolean = false
}

/** What is known whole before instruction [before]. */
internal class EmittedResult(
    val before: Int,
    val cells: IntArray,
    val name: String?,
    val line: Int,
    val origin: String,
    val guard: Emitted?,
)

/** Takes the instructions of a shader in their order, and hands out cells and labels. */
internal class Emitter {
    val code = ArrayList<Emitted>()
    val initial = ArrayList<Double>()
    val sources = ArrayList<Source?>()
    val textures = ArrayList<TextureCall>()
    val switches = ArrayList<SwitchTable>()

    /** What is known whole, in order. */
    val results = ArrayList<EmittedResult>()

    /** Where each label stands. */
    val labels = ArrayList<Int>()
    private val variables = TreeMap<Int, IntRange>()
    private val constants = HashMap<Long, Int>()

    /** What the next instructions are made from, and the branch that they depend on. */
    var line: Int = 0
    var origin: String = ""
    var guard: Emitted? = null

    /** A new cell. */
    fun cell(source: Source? = null, value: Double = 0.0): Int {
        if (initial.size >= MAX_CELLS) throw UnreadableException("more than $MAX_CELLS numbers at once", line)
        initial += value
        sources += source
        return initial.size - 1
    }

    /** The cells of the variable that [cell] belongs to; a variable is announced by its first cell. */
    fun variableAt(cell: Int): IntRange = checkNotNull(variables.floorEntry(cell)).value

    fun addVariable(cells: IntRange) {
        variables[cells.first] = cells
    }

    fun constant(value: Double): Int = constants.getOrPut(value.toRawBits()) { cell(Source.Constant(value), value) }

    /** The new cell of the result. [c] of the operations on integers is 1 where it has no sign. */
    fun op(operation: Operation, a: Int, b: Int = 0, c: Int = 0): Int = cell().also { emit(operation, it, a, b, c) }

    fun emit(operation: Operation, target: Int, a: Int = 0, b: Int = 0, c: Int = 0): Emitted {
        if (code.size >= MAX_INSTRUCTIONS) {
            throw UnreadableException("more than $MAX_INSTRUCTIONS operations, functions put where they are called", line)
        }
        return Emitted(operation, target, a, b, c, line, origin, guard).also { code += it }
    }

    /** Remembers that [cells] are a result as a whole. */
    fun result(cells: IntArray, name: String? = null) {
        results += EmittedResult(code.size, cells, name, line, origin, guard)
    }

    fun newLabel(): Int = labels.size.also { labels += -1 }

    /** [label] stands here. */
    fun place(label: Int) {
        labels[label] = code.size
    }

    fun jump(label: Int) {
        emit(JUMP, 0, label)
    }

    fun branch(
        condition: Int,
        whenTrue: Int,
        whenFalse: Int,
    ): Emitted = emit(BRANCH, cell(), condition, whenTrue, whenFalse)

    fun switch(selector: Int, labels: Map<Int, Int>, default: Int): Emitted {
        switches += SwitchTable(labels, default)
        return emit(SWITCH, cell(), selector, switches.size - 1)
    }

    private companion object {
        const val MAX_CELLS = 1 shl 18
        const val MAX_INSTRUCTIONS = 200_000
    }
}
