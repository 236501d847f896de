package cga.exercise.components.shader

import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL33C.*

/** The names of a program's uniforms, and the sentence for a name that is not among them. */
public object UniformNames {
    /** Every uniform of the linked [program] that can be set, arrays of structs written out. */
    public fun of(program: Int): List<String> {
        val size = BufferUtils.createIntBuffer(1)
        val type = BufferUtils.createIntBuffer(1)
        return List(glGetProgrami(program, GL_ACTIVE_UNIFORMS)) { glGetActiveUniform(program, it, size, type) }
    }

    /**
     * Whether the shader [source] declares [name], though the program has no use for it: a plain uniform, or a member of a struct or of an
     * array of them. Where the program [known] to use these names uses the same one at another index, this index is too large.
     */
    public fun isDeclared(
        name: String,
        known: List<String>,
        source: String,
    ): Boolean {
        val path = withoutIndices(name).split('.')

        fun declares(
            type: String,
            variable: String,
        ) = Regex("""\b$type\s+${Regex.escape(variable)}\s*(\[[^]]*])?\s*;""").containsMatchIn(source)
        return known.none { withoutIndices(it) == withoutIndices(name) } &&
            declares("""uniform\s+\w+""", path.first()) &&
            path.drop(1).all { declares("""\w+""", it) }
    }

    private fun withoutIndices(name: String) = name.replace(Regex("""\[\d+]"""), "")

    public fun unknown(
        name: String,
        known: List<String>,
        program: String,
    ): String {
        val nearest = known.minByOrNull { distance(it, name) }
        val hint = if (nearest == null) "It has no uniforms at all." else "Did you mean $nearest?"
        return "warning: uniform $name is not in $program. $hint"
    }

    /** Levenshtein's edit distance. */
    public fun distance(
        a: String,
        b: String,
    ): Int {
        var row = IntArray(b.length + 1) { it }
        for (i in a.indices) {
            val next = IntArray(b.length + 1)
            next[0] = i + 1
            for (j in b.indices) {
                val replaced = row[j] + if (a[i] == b[j]) 0 else 1
                next[j + 1] = minOf(replaced, row[j + 1] + 1, next[j] + 1)
            }
            row = next
        }
        return row[b.length]
    }
}
