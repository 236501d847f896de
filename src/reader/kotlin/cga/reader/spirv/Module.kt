package cga.reader.spirv

/**
 * One instruction.
 *
 * @property type the id of the result's type, 0 without one.
 * @property id the result's id, 0 without one.
 * @property operands the other words.
 * @property line the line of the GLSL that it was made from, 0 where it is not known.
 */
internal class Instruction(
    val op: Op,
    val type: Int,
    val id: Int,
    val operands: IntArray,
    val line: Int,
) {
    /** The operands from [start] on. */
    fun from(start: Int): IntArray = operands.drop(start).toIntArray()
}

/** Instructions that run one after the other; the last one says where to go on. */
internal class Block(val label: Int, val instructions: List<Instruction>)

internal class Function(
    val id: Int,
    val parameters: List<Int>,
    val blocks: List<Block>,
)

/** A variable outside of functions, [line] 0. [initializer] is the id of a constant, or 0. */
internal class GlobalVariable(
    val id: Int,
    val name: String,
    val type: Type,
    val storage: Storage,
    val builtIn: BuiltIn?,
    val location: Int?,
    val initializer: Int,
)

/** A constant, its cells as numbers. */
internal class Constant(val type: Type, val cells: DoubleArray)

/** A module of SPIR-V, its declarations resolved. [computed] are constants that an operation makes of others. */
internal class Module(
    val entry: Int,
    val types: Map<Int, Type>,
    val constants: Map<Int, Constant>,
    val computed: List<Instruction>,
    val variables: List<GlobalVariable>,
    val functions: Map<Int, Function>,
    val names: Map<Int, String>,
)

/** The module cannot be read; the message says why. [line] is that of the GLSL, 0 where it is not known. */
internal class UnreadableException(
    message: String,
    val line: Int = 0,
) : RuntimeException(message)
