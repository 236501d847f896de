package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.shader.Operation.DIV
import cga.reader.shader.Operation.TEXTURE
import cga.reader.shader.Operation.TEXTURE_SIZE
import cga.reader.shader.TextureCall
import cga.reader.spirv.Instruction
import cga.reader.spirv.Op
import cga.reader.spirv.Type
import cga.reader.spirv.UnreadableException

private const val BIAS = 1
private const val LOD = 2
private const val GRADIENT = 4
private const val CONST_OFFSET = 8
private const val OFFSET = 16

/** Looks into textures. */
internal class Textures(private val emitter: Emitter) {
    /** The result, or null where [instruction] is of another sort. */
    fun lower(instruction: Instruction, scope: Scope): Value? {
        val type = scope.type(instruction.type)
        val operands = instruction.operands
        return when (instruction.op) {
            Op.IMAGE_QUERY_SIZE_LOD, Op.IMAGE_QUERY_SIZE -> {
                val level = operands.getOrNull(1)?.let { scope.value(it).cell } ?: emitter.constant(0.0)
                look(scope.value(operands[0]), intArrayOf(level), type.cells, TEXTURE_SIZE)
            }
            Op.IMAGE_FETCH -> sample(type, scope, instruction, 2)
            else -> {
                if (!instruction.op.name.startsWith("IMAGE_SAMPLE")) return null
                sample(type, scope, instruction, if ("DREF" in instruction.op.name) 3 else 2)
            }
        }.let { Value(type, it) }
    }

    private fun sample(type: Type, scope: Scope, instruction: Instruction, extrasAt: Int): IntArray {
        val sampler = scope.value(instruction.operands[0])
        val image = sampler.type as Type.Image
        val name = instruction.op.name
        val extras = instruction.from(extrasAt + 1).map(scope::value).toMutableList()
        val mask = instruction.operands.getOrElse(extrasAt) { 0 }

        fun extra(bit: Int) = if (mask and bit != 0) extras.removeFirst().cells else IntArray(0)
        val isShadow = "DREF" in name
        val count = image.dimensions + if (image.isArray) 1 else 0
        val given = scope.value(instruction.operands[1]).cells
        val reference = if (isShadow) intArrayOf(scope.value(instruction.operands[2]).cell) else IntArray(0)

        fun projected(cells: IntArray) = if ("PROJ" in name) cells.map { emitter.op(DIV, it, given[count]) }.toIntArray() else cells
        if (mask and (BIAS or LOD or GRADIENT or CONST_OFFSET or OFFSET) != mask) {
            throw UnreadableException("a look into a texture with operands $mask is not known")
        }
        val bias = extra(BIAS)
        val lod = extra(LOD)
        val gradientX = extra(GRADIENT)
        val gradientY = if (gradientX.isEmpty()) gradientX else extras.removeFirst().cells
        val offset = extra(CONST_OFFSET) + extra(OFFSET)
        val call = TextureCall(
            sampler.cell,
            projected(given.copyOf(count)),
            instruction.op == Op.IMAGE_FETCH,
            isShadow,
            projected(reference).singleOrNull() ?: -1,
            bias.singleOrNull() ?: -1,
            lod.singleOrNull() ?: -1,
            gradientX,
            gradientY,
            offset,
            type.cells,
        )
        return emit(call)
    }

    private fun look(sampler: Value, where: IntArray, results: Int, operation: Operation): IntArray {
        val none = IntArray(0)
        return emit(TextureCall(sampler.cell, where, false, false, -1, -1, -1, none, none, none, results), operation)
    }

    /** The cells of the results, one after the other; the instruction names the first, and the call. */
    private fun emit(call: TextureCall, operation: Operation = TEXTURE): IntArray {
        emitter.textures += call
        val cells = IntArray(call.results) { emitter.cell() }
        emitter.emit(operation, cells[0], emitter.textures.size - 1)
        return cells
    }
}
