package cga.grading.substitute

/**
 * What the source of a stand-in declares.
 *
 * @property shared types, constants and uniforms, as they are written.
 */
internal class Declarations private constructor(
    val shared: List<String>,
    val inputs: List<Declared>,
    val outputs: List<Declared>,
) {
    /** A variable, and the whole of its declaration. */
    class Declared(
        val type: String,
        val name: String,
        val text: String,
    )

    companion object {
        /** Of [source], which the worker's stub wrote: a declaration a line, structs over several. */
        fun of(source: String): Declarations {
            val head = source.substringBefore("void main")
            return Declarations(SHARED.findAll(head).map { it.value.trim() }.toList(), variables(head, "in"), variables(head, "out"))
        }

        private fun variables(
            head: String,
            direction: String,
        ): List<Declared> =
            Regex("""(?m)^(?:layout\s*\([^)]*\)\s*)?(?:(?:flat|smooth|noperspective|centroid)\s+)*$direction\s+(\w+)\s+([\w\s,]+);""")
                .findAll(head)
                .flatMap { all -> all.groupValues[2].split(',').map { Declared(all.groupValues[1], it.trim(), all.value) } }
                .toList()

        private val SHARED = Regex("""(?m)^(?:struct\s+\w+\s*\{[^}]*};|uniform\s[^;]*;|const\s[^;]*;|#define[^\n]*$)""")
    }
}
