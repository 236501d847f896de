package cga.grading.worker

/**
 * A shader's source with single uniforms in the place of uniform blocks, so that whoever draws it again can hand it one value at a time.
 * A block without an instance becomes the uniforms that it is made of, one with an instance a uniform struct: both keep the names by which the
 * shader reads them. What has no block is left as it is. Arrays of blocks are not followed.
 */
internal class PlainUniforms(source: String) {
    private val instances = LinkedHashMap<String, String>()

    /** The source without blocks. */
    val source: String =
        withoutComments(source).let { text -> if (BLOCK.containsMatchIn(text)) BLOCK.replace(text) { plain(it) } else source }

    /**
     * What this source calls the member that OpenGL calls [name]: `Camera.view` is `camera.view` where the block Camera has the instance
     * camera. Null where this source has no such block.
     */
    fun name(name: String): String? {
        val instance = instances[name.substringBefore('.', "")] ?: return null
        return "$instance.${name.substringAfter('.')}"
    }

    private fun plain(block: MatchResult): String {
        val (name, members, instance) = block.destructured
        val plainMembers = members.replace(LAYOUT, "")
        if (instance.isEmpty()) return plainMembers.replace(MEMBER, "$1uniform $2")
        instances[name] = instance
        // The members of a struct are on lines of their own: some may be left out by #if.
        return "struct ${name}_members {$plainMembers};\nuniform ${name}_members $instance;"
    }

    private companion object {
        const val QUALIFIER = """layout\s*\([^)]*\)\s*"""
        val LAYOUT = Regex(QUALIFIER)
        val BLOCK = Regex("""\b(?:$QUALIFIER)?uniform\s+(\w+)\s*\{([^}]*)}\s*(\w*)\s*;""")

        // A declaration, behind lines for the preprocessor.
        val MEMBER = Regex("""((?:\s|#[^\n]*\n)*)([^;#]*;)""")
    }
}
