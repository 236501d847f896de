package cga.grading.reading

import cga.reader.shader.Operation
import cga.reader.shader.Source
import cga.reader.shader.Stage
import cga.reader.tape.Tape
import cga.reader.tape.TapeResult

/** A line of one of the two shaders; 0 where it is not known. */
internal data class ShaderLine(val stage: Stage, val line: Int)

/**
 * A number of a run: what made it, and of which numbers.
 *
 * @property key the same for the same quantity in several runs; see [Keys].
 * @property operation null for what no operation made.
 * @property source where it comes from then.
 */
internal class Node(
    val key: Long,
    val value: Double,
    val operation: Operation?,
    val operands: List<Node>,
    val source: Source?,
    val line: ShaderLine,
    val origin: String,
)

/** Three numbers that belong together, a vector or the first three of four. */
internal class NodeVector(
    val key: Long,
    val nodes: List<Node>,
    val line: ShaderLine,
)

/** Numbers the quantities of a program, so that those of several runs can be compared: operations by where they are, all else by what it is. */
internal class Keys {
    private val numbers = HashMap<Any, Long>()

    /** Below 0. */
    fun of(what: Any): Long = numbers.getOrPut(what) { -1L - numbers.size }

    companion object {
        /** Of component [component] of what the operation at [place] made in its round [round]. */
        fun of(stage: Stage, place: Int, round: Int, component: Int): Long =
            stage.ordinal.toLong() shl 62 or (place.toLong() shl 32) or (round.toLong() shl 4) or component.toLong()
    }
}

/** What was computed in a run, without how: the keys of its numbers and their values. */
internal class Row(private val keys: LongArray, private val values: DoubleArray) {
    /** NaN where it was not computed. */
    operator fun get(key: Long): Double = keys.indexOf(key).let { if (it < 0) Double.NaN else values[it] }

    companion object {
        fun of(vertex: Tape, fragment: Tape): Row {
            val keys = LongArray(vertex.size + fragment.size)
            val values = DoubleArray(keys.size)
            add(vertex, Stage.VERTEX, 0, keys, values)
            add(fragment, Stage.FRAGMENT, vertex.size, keys, values)
            return Row(keys, values)
        }

        private fun add(tape: Tape, stage: Stage, start: Int, keys: LongArray, values: DoubleArray) {
            for (entry in 0 until tape.size) {
                keys[start + entry] = Keys.of(stage, tape.place(entry), tape.round(entry), 0)
                values[start + entry] = tape.value(entry)
            }
        }
    }
}

/**
 * One run of both shaders as one graph: what the fragment shader reads is what the vertex shader wrote.
 *
 * @property color red, green and blue.
 */
internal class Trace private constructor(
    val color: List<Node>,
    val position: List<Node>?,
    val nodes: List<Node>,
    val vectors: List<NodeVector>,
) {
    companion object {
        /** [vertex] is null inside of a triangle, where the inputs of the fragment shader are no vertex's. */
        fun of(pair: ShaderPair, keys: Keys, vertex: Tape?, fragment: Tape): Trace {
            val first = vertex?.let { Stretch(it, Stage.VERTEX, keys, null) }
            val second = Stretch(fragment, Stage.FRAGMENT, keys, first)
            val color = checkNotNull(pair.color) { "a pair without a colour is not traced" }
            return Trace(
                second.output(color.name).take(ShaderPair.CHANNELS),
                first?.output("gl_Position"),
                first?.all.orEmpty() + second.all,
                first?.vectors.orEmpty() + second.vectors + uniforms(keys, first?.all.orEmpty() + second.all),
            )
        }

        /** The vectors that are sent. */
        private fun uniforms(keys: Keys, nodes: List<Node>): List<NodeVector> =
            nodes
                .filter { (it.source as? Source.Uniform)?.slot?.let { slot -> slot.columns == 1 && slot.size in 3..4 } == true }
                .groupBy { (it.source as Source.Uniform).slot.name }
                .mapNotNull { (name, parts) ->
                    val three = (0..2).map { i -> parts.find { (it.source as Source.Uniform).component == i } ?: return@mapNotNull null }
                    NodeVector(keys.of(listOf("vector", name)), three, three[0].line)
                }

        /** A run of the vertex shader alone. */
        fun ofVertex(keys: Keys, vertex: Tape): Trace =
            Stretch(vertex, Stage.VERTEX, keys, null).let { Trace(emptyList(), it.output("gl_Position"), it.all, it.vectors) }
    }
}

/** The part of a graph that one shader makes. */
private class Stretch(
    private val tape: Tape,
    private val stage: Stage,
    private val keys: Keys,
    private val before: Stretch?,
) {
    val nodes = ArrayList<Node>(tape.size)
    private val sources = HashMap<Int, Node>()

    init {
        var component = 0
        for (entry in 0 until tape.size) {
            // The components of a look into a texture follow one another and are of one place.
            val isNext = entry > 0 && tape.operation(entry) == Operation.TEXTURE && tape.place(entry) == tape.place(entry - 1) &&
                tape.round(entry) == tape.round(entry - 1)
            component = if (isNext) component + 1 else 0
            nodes += node(entry, component)
        }
    }

    /** What it computed, and what of. */
    val all: List<Node> get() = nodes + sources.values

    val vectors: List<NodeVector> = tape.results.filter { it.references.size in 3..4 }.map(::vector)

    fun output(name: String): List<Node> = tape.references(name).map(::at)

    private fun node(entry: Int, component: Int) =
        Node(
            Keys.of(stage, tape.place(entry), tape.round(entry), component),
            tape.value(entry),
            tape.operation(entry),
            List(tape.operandCount(entry)) { at(tape.operand(entry, it)) },
            null,
            ShaderLine(stage, tape.line(entry)),
            tape.origin(entry),
        )

    private fun vector(result: TapeResult) =
        NodeVector(
            keys.of(listOf(stage, "vector", result.place, result.round)),
            result.references.take(3).map(::at),
            ShaderLine(stage, result.line),
        )

    private fun at(reference: Int): Node = if (reference >= 0) nodes[reference] else sources.getOrPut(reference) { given(reference) }

    private fun given(reference: Int): Node {
        val source = tape.source(reference)
        if (source is Source.Input && before != null) {
            val output = before.tape.shaderOutput(source.slot.name)
            if (output != null && source.component < output.size) return before.at(output[source.component])
        }
        // A uniform is the same in both shaders.
        val what: Any = when (source) {
            is Source.Uniform -> listOf(source.slot.name, source.component)
            is Source.Input -> listOf(stage, source.slot.name, source.component)
            is Source.Constant -> source
            is Source.Unset -> listOf(stage, "unset", source.variable)
        }
        return Node(keys.of(what), tape.value(reference), null, emptyList(), source, ShaderLine(stage, 0), "")
    }

    private fun Tape.shaderOutput(name: String): IntArray? = runCatching { references(name) }.getOrNull()
}
