package cga.reader.shader

/** Which part of the pipeline a shader is. */
public enum class Stage { VERTEX, FRAGMENT }

/**
 * A shader as a list of operations on single numbers, made once and run often.
 *
 * Every number has a *cell*: constants, uniforms, inputs, outputs, variables and the results of operations. Functions stand where they
 * are called. An instruction is [STRIDE] words: the ordinal of its [Operation], the cell of the result, and three operands.
 */
public class Shader internal constructor(
    public val stage: Stage,
    /** By the names of OpenGL; samplers are among them. */
    public val uniforms: List<Slot>,
    public val inputs: List<Slot>,
    public val outputs: List<Slot>,
    internal val code: IntArray,
    private val lines: IntArray,
    private val origins: Array<String>,
    /** The instruction that decides whether this one runs, or -1. */
    internal val guards: IntArray,
    /** Which instructions decide whether a loop goes on. */
    internal val loopTests: BooleanArray,
    internal val initial: DoubleArray,
    private val sources: Array<Source?>,
    internal val textures: List<TextureCall>,
    internal val switches: List<SwitchTable>,
    internal val results: Results,
) {
    private val byName = (uniforms + inputs + outputs).associateBy { it.name }

    /** Samplers in the order of their handles. */
    internal val samplers: List<Slot> = uniforms.filter { it.kind == Kind.SAMPLER }

    /** How many operations, over and over in loops but once here. */
    public val size: Int get() = lines.size

    /** The uniform, input or output of that name, or null. */
    public fun slot(name: String): Slot? = byName[name]

    /** The line of the GLSL that instruction [at] was made from, 0 where it is not known. */
    internal fun line(at: Int): Int = lines[at]

    /** What instruction [at] was part of, as SPIR-V or its GLSL instructions call it: `normalize`, `dot`, `f_mul`. */
    internal fun origin(at: Int): String = origins[at]

    internal fun operation(at: Int): Operation = OPERATIONS[code[at * STRIDE]]

    /** What is in [cell] before anything ran; null for the results of operations. */
    internal fun source(cell: Int): Source? = sources[cell]

    internal companion object {
        const val STRIDE: Int = 5
        val OPERATIONS: Array<Operation> = Operation.entries.toTypedArray()
    }
}

/**
 * What the instructions leave whole: vectors, matrices, and what is assigned to variables.
 *
 * @param starts the first of those that are known before an instruction, and one more at the end.
 */
internal class Results(
    val starts: IntArray,
    val all: Array<Result>,
)

/** A result: its cells, the [line], the [name] of the variable that it is assigned to or null, what made it, and the branch that decides whether it is there, or -1. */
internal class Result(
    val cells: IntArray,
    val line: Int,
    val name: String?,
    val origin: String,
    val guard: Int,
)
