package cga.grading.analysis

import cga.grading.study.LiftedConstants

/**
 * The uniforms that shaders declare, with the members of their structs: a name among them is spelt right, even if the compiler dropped it.
 *
 * @param sources of all shaders.
 * @param active names of the uniforms that the programs have.
 */
internal class UniformDeclarations(
    sources: List<String>,
    active: Set<String>,
) {
    private val texts = sources.map(LiftedConstants::withoutComments)
    private val kept = active.map(::withoutIndices).toSet()

    /** The type of each plain uniform. */
    private val types: Map<String, String> =
        texts
            .flatMap { UNIFORM.findAll(it) + INLINE.findAll(it) }
            .flatMap { variables(it.groupValues[1], it.groupValues[2]) }
            .toMap()

    /** The members of each struct, with their types. */
    private val structs: Map<String, Map<String, String>> =
        texts.flatMap { text -> STRUCT.findAll(text).map { it.groupValues[1] to members(it.groupValues[2]) } }.toMap()

    /** Whether [name] (`lights[2].color`) is declared. Where the same is in use at another index, this index is too large. */
    fun declares(name: String): Boolean {
        val path = withoutIndices(name).split('.')
        if (withoutIndices(name) in kept && '[' in name) return false
        var type = types[path.first()] ?: return false
        for (member in path.drop(1)) type = structs[type]?.get(member) ?: return false
        return true
    }

    private fun members(body: String): Map<String, String> =
        body.split(';').mapNotNull { MEMBER.find(it) }.flatMap { variables(it.groupValues[1], it.groupValues[2]) }.toMap()

    /** The names of a declaration of several variables: `a, b[4] = …`. */
    private fun variables(
        type: String,
        names: String,
    ): List<Pair<String, String>> = names.split(',').mapNotNull { WORD.find(it)?.value }.map { it to type }

    private companion object {
        fun withoutIndices(name: String): String = name.replace(INDEX, "")

        val INDEX = Regex("""\[\d+]""")
        val WORD = Regex("""[A-Za-z_]\w*""")
        private const val PRECISION = """(?:(?:lowp|mediump|highp)\s+)?"""
        val UNIFORM = Regex("""\buniform\s+$PRECISION(\w+)\s+([^;{}]+);""")
        val INLINE = Regex("""\buniform\s+struct\s+(\w+)\s*\{[^}]*}\s*([^;]+);""")
        val MEMBER = Regex("""^\s*$PRECISION(\w+)\s+(.+)$""", RegexOption.DOT_MATCHES_ALL)
        val STRUCT = Regex("""\bstruct\s+(\w+)\s*\{([^}]*)}""")
    }
}
