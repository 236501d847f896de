package cga.grading.worker

/**
 * GLSL that takes the place of a shader that does not compile: it has the same inputs, outputs and uniforms, as far as they can be read
 * from [source], uses each uniform and vertex attribute, and draws nothing of use (the vertex stage puts everything out of sight, the fragment stage is one colour).
 */
internal class ShaderStub(
    source: String,
    private val isVertex: Boolean,
) {
    private val text = withoutComments(source)
    private val structs =
        STRUCT.findAll(text).associate { found ->
            found.groupValues[1] to MEMBER.findAll(found.groupValues[2]).flatMap(::declared).toList()
        }
    private val uniforms = UNIFORM.findAll(text).flatMap(::declared).filter { isKnown(it.type) }.distinctBy { it.name }.toList()
    private val attributes = if (isVertex) ATTRIBUTE.findAll(text).flatMap(::declared).filter { isKnown(it.type) }.toList() else emptyList()
    private val inputs = INPUT.findAll(text).map { it.value.trim() }.toList()
    private val outputs = OUTPUT.findAll(text).map { it.value.trim() }.toList()

    /** With everything that was found in the source. */
    val full: String = write(declarations(), (uniforms + attributes).flatMap { uses(it.name, it.type, it.array, 0) })

    /** As [full], without what passes between the stages: fits any other stage's [alone]. */
    val alone: String = write(declarations(isAlone = true), (uniforms + attributes).flatMap { uses(it.name, it.type, it.array, 0) })

    /** With nothing but what every stage has. */
    val bare: String = write(if (isVertex) emptyList() else listOf("out vec4 standInColor;"), emptyList())

    private class Declared(
        val type: String,
        val name: String,
        val array: String?,
    )

    private fun declared(found: MatchResult): Sequence<Declared> {
        val (type, names) = found.destructured
        return names.splitToSequence(',').mapNotNull { one ->
            NAME.matchEntire(one.substringBefore('=').trim())?.let { Declared(type, it.groupValues[1], it.groupValues[2].ifEmpty { null }) }
        }
    }

    private fun declarations(isAlone: Boolean = false): List<String> {
        val macros = Regex("""(?m)^[ \t]*#[ \t]*define[ \t]+\w+[ \t]+\d+[ \t]*$""").findAll(text).map { it.value.trim() }
        val constants = Regex("""\bconst\s+u?int\s+\w+\s*=\s*\w+\s*;""").findAll(text).map { it.value }
        val types =
            structs.filter { (_, members) -> members.isNotEmpty() && members.all { isKnown(it.type) } }.map { (name, members) ->
                "struct $name {\n" + members.joinToString("") { "    ${it.type} ${it.name}${brackets(it.array)};\n" } + "};"
            }
        val received = if (isAlone && !isVertex) emptyList() else inputs
        val sent = if (isAlone && isVertex) emptyList() else outputs
        val color = if (!isVertex && outputs.isEmpty()) listOf("out vec4 standInColor;") else emptyList()
        return macros.toList() + constants.toList() + types + received + sent + color +
            uniforms.map { "uniform ${it.type} ${it.name}${brackets(it.array)};" }
    }

    private fun write(
        declarations: List<String>,
        uses: List<String>,
    ): String {
        val sum = (listOf("0.0") + uses).joinToString(" +\n        ")
        val end =
            when {
                isVertex -> "gl_Position = vec4(3.0 + abs(sum), 0.0, 0.0, 1.0);"
                else -> "${color(declarations)} = vec4(1.0, clamp(sum, 0.0, 0.001), 1.0, 1.0);"
            }
        return "#version 330 core\n${declarations.joinToString("\n")}\nvoid main() {\n    float sum = $sum;\n    $end\n}\n"
    }

    private fun color(declarations: List<String>): String =
        declarations.firstNotNullOfOrNull { Regex("""\bout\s+(?:\w+\s+)*vec4\s+(\w+)\s*;""").find(it)?.groupValues?.get(1) }
            ?: "vec4 unused"

    /** Expressions that read every number of the variable [path], so that the compiler must keep it. */
    private fun uses(
        path: String,
        type: String,
        array: String?,
        depth: Int,
    ): List<String> {
        if (depth > MAX_DEPTH) return emptyList()
        if (array != null) {
            val size = size(array) ?: return listOf("float($path.length())")
            return (0 until size).flatMap { uses("$path[$it]", type, null, depth + 1) }
        }
        structs[type]?.let { members -> return members.flatMap { uses("$path.${it.name}", it.type, it.array, depth + 1) } }
        return listOf(
            when {
                type.startsWith("mat") -> "dot($path[0], $path[0])"
                type == "sampler2D" -> "texture($path, vec2(0.5)).r"
                type.endsWith("vec2") || type.endsWith("vec3") || type.endsWith("vec4") -> "float($path.x)"
                else -> "float($path)"
            },
        )
    }

    private fun size(array: String): Int? {
        val number =
            array.trim().toIntOrNull()
                ?: Regex("""\b${Regex.escape(array.trim())}\s*=?\s*(\d+)""").find(text)?.groupValues?.get(1)?.toIntOrNull()
        return number?.takeIf { it in 1..MAX_ELEMENTS }
    }

    private fun isKnown(type: String) = type in structs || type in TYPES

    private fun brackets(array: String?) = if (array == null) "" else "[$array]"

    private companion object {
        const val MAX_DEPTH = 6
        const val MAX_ELEMENTS = 256
        const val LIST = """([\w\s,\[\]=.()+*/-]+?)"""
        val STRUCT = Regex("""\bstruct\s+(\w+)\s*\{([^}]*)\}""")
        val MEMBER = Regex("""(?:\b(?:lowp|mediump|highp)\s+)?\b(\w+)\s+([\w\s,\[\]]+);""")
        val UNIFORM = Regex("""\buniform\s+(?:(?:lowp|mediump|highp)\s+)?(\w+)\s+$LIST;""")
        val ATTRIBUTE = Regex("""\bin\s+(\w+)\s+$LIST;""")
        val NAME = Regex("""(\w+)\s*(?:\[\s*(\w+)\s*])?""")
        val INPUT = declaration("in")
        val OUTPUT = declaration("out")
        val TYPES =
            setOf("float", "int", "uint", "bool", "sampler2D") +
                listOf("vec", "ivec", "uvec", "bvec", "mat").flatMap { kind -> (2..4).map { "$kind$it" } }

        // At the start of a line or after another declaration; parameters of functions have no semicolon.
        fun declaration(direction: String) =
            Regex(
                """(?:\blayout\s*\([^)]*\)\s*)?(?:\b(?:flat|smooth|noperspective|centroid)\s+)*\b$direction\s+""" +
                    """(?:\w+\s+[\w\s,\[\]]+;|\w+\s*\{[^}]*\}\s*\w*\s*(?:\[\w*])?\s*;)""",
            )
    }
}
