package cga.reader.mesa

import cga.reader.spirv.GlobalVariable
import cga.reader.spirv.ModuleReader
import cga.reader.spirv.Op
import cga.reader.spirv.Storage
import cga.reader.spirv.Type
import cga.reader.spirv.instructions

/** A vertex shader that hands a fragment shader what uniforms hold, without a change: at a point nothing is interpolated. */
internal class Varyings(binary: ByteArray) {
    private val instructions = instructions(binary)
    private val decorations = instructions.filter { it.op == Op.DECORATE }.map { it.operands[0] to it.operands[1] }.toSet()
    private val inputs = ModuleReader(instructions).read().variables.filter { it.storage == Storage.INPUT && it.builtIn == null }
    private val structs = LinkedHashMap<String, String>()
    private val isBlock = { type: Type -> type is Type.Struct && type.isBlock }

    /** The source; the point [PLACE] of a row of them. */
    val source: String = buildString {
        val declarations = inputs.joinToString("\n") { "${qualifier(it)}out ${declaration(it)};" }
        val uniforms = inputs.withIndex().flatMap { (i, input) -> uniforms(i, input) }
        appendLine("#version 330 core")
        structs.values.forEach(::appendLine)
        appendLine(declarations)
        for ((name, _, type) in uniforms) appendLine("uniform ${declare(type, name)};")
        appendLine("uniform float $PLACE;")
        appendLine("void main() {")
        for ((name, target, _) in uniforms) appendLine("    $target = $name;")
        appendLine("    gl_Position = vec4($PLACE, 0.0, 0.0, 1.0);\n}")
    }

    /** The uniform that an input of the fragment shader is handed over in. */
    fun uniformOf(input: String): String {
        for ((i, variable) in inputs.withIndex()) {
            val type = variable.type
            if (type is Type.Struct && type.isBlock) {
                val member = type.members.indexOfFirst { input.matches(Regex("(?:${type.name}\\.)?${it.name}(?:[.\\[].*)?")) }
                if (member >= 0) return "cga_${i}_$member" + input.removePrefix("${type.name}.").removePrefix(type.members[member].name)
            } else if (input.matches(Regex("${variable.name}(?:[.\\[].*)?"))) {
                return "cga_$i" + input.removePrefix(variable.name)
            }
        }
        error("no uniform for $input")
    }

    private fun uniforms(i: Int, input: GlobalVariable): List<Triple<String, String, Type>> {
        val type = input.type
        if (type !is Type.Struct || !type.isBlock) return listOf(Triple("cga_$i", input.name, type))
        val prefix = if (input.name.isEmpty()) "" else "${input.name}."
        return type.members.mapIndexed { k, member -> Triple("cga_${i}_$k", prefix + member.name, member.type) }
    }

    private fun qualifier(input: GlobalVariable) =
        (if (input.id to FLAT in decorations) "flat " else "") + if (input.id to NO_PERSPECTIVE in decorations) "noperspective " else ""

    private fun declaration(input: GlobalVariable): String {
        val type = input.type
        if (!isBlock(type)) return declare(type, input.name)
        val members = (type as Type.Struct).members.joinToString(" ") { declare(it.type, it.name) + ";" }
        return "${type.name} { $members } ${input.name}"
    }

    private fun declare(type: Type, name: String): String = if (type is Type.Array) {
        declare(
            type.element,
            "$name[${type.count}]",
        )
    } else {
        "${glsl(type)} $name"
    }

    private fun glsl(type: Type): String =
        when (type) {
            Type.Float -> "float"
            is Type.Integer -> if (type.isSigned) "int" else "uint"
            is Type.Vector -> if (type.component == Type.Float) "vec${type.count}" else "${glsl(type.component).first()}vec${type.count}"
            is Type.Matrix -> if (type.count == type.column.count) "mat${type.count}" else "mat${type.count}x${type.column.count}"
            is Type.Struct -> type.name.also { name ->
                val members = type.members.joinToString(" ") { declare(it.type, it.name) + ";" }
                structs[name] = "struct $name { $members };"
            }
            else -> error("no varying is a ${type::class.simpleName}")
        }

    companion object {
        const val PLACE = "cga_place"
        private const val NO_PERSPECTIVE = 13
        private const val FLAT = 14
    }
}
