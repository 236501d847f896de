package cga.reader.spirv

private const val BLOCK = 2
private const val BUILT_IN = 11
private const val LOCATION = 30
private const val CUBE = 3

/** The module that [instructions] say. Throws [UnreadableException] where they are not as SPIR-V has them. */
internal class ModuleReader(private val instructions: List<Instruction>) {
    private val names = HashMap<Int, String>()
    private val memberNames = HashMap<Pair<Int, Int>, String>()
    private val decorations = HashMap<Pair<Int, Int>, Int>()
    private val memberBuiltIns = HashMap<Pair<Int, Int>, Int>()
    private val types = HashMap<Int, Type>()
    private val constants = HashMap<Int, Constant>()
    private val computed = ArrayList<Instruction>()
    private val variables = ArrayList<GlobalVariable>()
    private val functions = LinkedHashMap<Int, Function>()
    private var entry = 0

    fun read(): Module {
        val firstFunction = instructions.indexOfFirst { it.op == Op.FUNCTION }.takeIf { it >= 0 } ?: instructions.size
        for (instruction in instructions.subList(0, firstFunction)) naming(instruction) { declare(instruction) }
        readFunctions(instructions.subList(firstFunction, instructions.size))
        if (entry !in functions) throw UnreadableException("the module has no entry point")
        return Module(entry, types, constants, computed, variables, functions, names)
    }

    private fun declare(instruction: Instruction) {
        val operands = instruction.operands
        when (instruction.op) {
            Op.ENTRY_POINT -> entry = operands[1]
            Op.NAME -> names[operands[0]] = instruction.text(1)
            Op.MEMBER_NAME -> memberNames[operands[0] to operands[1]] = instruction.text(2)
            Op.DECORATE -> decorations[operands[0] to operands[1]] = operands.getOrElse(2) { 0 }
            Op.MEMBER_DECORATE -> if (operands[2] == BUILT_IN) memberBuiltIns[operands[0] to operands[1]] = operands[3]
            Op.EXT_INST_IMPORT -> {
                val set = instruction.text(0)
                if (set != "GLSL.std.450") throw UnreadableException("instructions of $set are not known")
            }
            Op.VARIABLE -> variables += variable(instruction)
            Op.SPEC_CONSTANT_OP -> computed += computation(instruction)
            else -> {
                if (instruction.op.name.startsWith("TYPE_")) types[instruction.id] = type(instruction)
                constant(instruction)?.let { constants[instruction.id] = it }
            }
        }
    }

    private fun computation(instruction: Instruction): Instruction {
        val op = Op.of(instruction.operands[0]) ?: throw UnreadableException("instruction ${instruction.operands[0]} is not known")
        return Instruction(op, instruction.type, instruction.id, instruction.from(1), instruction.line)
    }

    private fun type(instruction: Instruction): Type {
        val operands = instruction.operands
        return when (instruction.op) {
            Op.TYPE_BOOL -> Type.Bool
            Op.TYPE_INT -> Type.Integer(operands[1] == 1)
            Op.TYPE_FLOAT -> Type.Float
            Op.TYPE_VECTOR -> Type.Vector(types.getValue(operands[0]), operands[1])
            Op.TYPE_MATRIX -> Type.Matrix(types.getValue(operands[0]) as Type.Vector, operands[1])
            Op.TYPE_ARRAY -> Type.Array(types.getValue(operands[0]), constants.getValue(operands[1]).cells[0].toInt())
            Op.TYPE_STRUCT -> Type.Struct(
                names[instruction.id].orEmpty(),
                instruction.id to BLOCK in decorations,
                operands.mapIndexed { i, type ->
                    val place = instruction.id to i
                    Type.Member(memberNames[place] ?: "_$i", types.getValue(type), memberBuiltIns[place]?.let(BuiltIn::of))
                },
            )
            Op.TYPE_IMAGE -> Type.Image(dimensions(operands[1]), operands[1] == CUBE, operands[3] == 1)
            Op.TYPE_SAMPLED_IMAGE -> types.getValue(operands[0])
            Op.TYPE_POINTER -> Type.Pointer(Storage.of(operands[0]), types.getValue(operands[1]))
            Op.TYPE_FUNCTION -> Type.Function
            else -> Type.Void
        }
    }

    /** 1D, 2D, 3D, cube, rectangle, buffer. */
    private fun dimensions(dimension: Int) = intArrayOf(1, 2, 3, 3, 2, 1)[dimension]

    private fun constant(instruction: Instruction): Constant? {
        val type = types[instruction.type] ?: return null
        val cells = when (instruction.op) {
            Op.CONSTANT_TRUE, Op.SPEC_CONSTANT_TRUE -> doubleArrayOf(1.0)
            Op.CONSTANT, Op.SPEC_CONSTANT -> doubleArrayOf(number(type, instruction.operands[0]))
            Op.CONSTANT_COMPOSITE, Op.SPEC_CONSTANT_COMPOSITE ->
                instruction.operands.flatMap { constants.getValue(it).cells.asList() }.toDoubleArray()
            Op.CONSTANT_FALSE, Op.SPEC_CONSTANT_FALSE, Op.CONSTANT_NULL, Op.UNDEF -> DoubleArray(type.cells)
            else -> return null
        }
        if (cells.size != type.cells) throw UnreadableException("a constant of ${cells.size} numbers, not ${type.cells}")
        return Constant(type, cells)
    }

    private fun number(type: Type, bits: Int): Double =
        when (type) {
            Type.Float -> Float.fromBits(bits).toDouble()
            is Type.Integer -> if (type.isSigned) bits.toDouble() else bits.toUInt().toDouble()
            else -> throw UnreadableException("a constant of a type that has no numbers")
        }

    private fun variable(instruction: Instruction): GlobalVariable {
        val pointer = types.getValue(instruction.type) as Type.Pointer
        val id = instruction.id
        return GlobalVariable(
            id,
            names[id].orEmpty(),
            pointer.target,
            pointer.storage,
            decorations[id to BUILT_IN]?.let(BuiltIn::of),
            decorations[id to LOCATION],
            instruction.operands.getOrElse(1) { 0 },
        )
    }

    private fun readFunctions(body: List<Instruction>) {
        var id = 0
        val parameters = ArrayList<Int>()
        val blocks = ArrayList<Block>()
        var label = 0
        val open = ArrayList<Instruction>()
        for (instruction in body) {
            when (instruction.op) {
                Op.FUNCTION -> id = instruction.id
                Op.FUNCTION_PARAMETER -> parameters += instruction.id
                Op.FUNCTION_END -> {
                    if (open.isNotEmpty()) throw UnreadableException("a function ends within a block")
                    functions[id] = Function(id, parameters.toList(), blocks.toList())
                    parameters.clear()
                    blocks.clear()
                }
                Op.LABEL -> label = instruction.id
                Op.LINE, Op.NO_LINE, Op.NOP -> Unit
                else -> {
                    open += instruction
                    if (instruction.op.isTerminator) blocks += Block(label, open.toList()).also { open.clear() }
                }
            }
        }
    }
}

/** [action], where what does not fit SPIR-V's rules is told as a fault of [instruction], or of the whole where that is null. */
internal fun <T> naming(instruction: Instruction?, action: () -> T): T =
    try {
        action()
    } catch (e: UnreadableException) {
        throw if (e.line > 0 || instruction == null) e else UnreadableException(e.message.orEmpty(), instruction.line)
    } catch (_: IndexOutOfBoundsException) {
        throw malformed(instruction)
    } catch (_: NoSuchElementException) {
        throw malformed(instruction)
    } catch (_: IllegalArgumentException) {
        throw malformed(instruction)
    } catch (_: ClassCastException) {
        throw malformed(instruction)
    }

private fun malformed(instruction: Instruction?): UnreadableException {
    val what = instruction?.let { "SPIR-V's ${it.op} with operands ${it.operands.asList()}" } ?: "the SPIR-V module"
    return UnreadableException("$what is malformed", instruction?.line ?: 0)
}
