package cga.reader.glsl

private val VERSION = Regex("""(?m)^\s*#\s*version\s+(\d+)[^\n]*""")

/** The oldest GLSL that shaderc makes SPIR-V for OpenGL of. */
private const val OLDEST = 330
private const val NEWEST = 460

/** A way of writing that drivers take and shaderc does not, and how it is put otherwise, on the same line. */
internal enum class Repair(
    val what: String,
    private val apply: (String) -> String,
) {
    FLOAT_SUFFIX("1f is read as 1.0f", replacing("""(?<![\w.])(\d+)[fF]\b""", "$1.0f")),
    OLD_TEXTURE(
        "texture2D and its like are read as texture",
        replacing("""\b(?:texture|shadow)(?:1D|2D|3D|Cube)((?:Proj)?(?:Lod|Grad)?)(?=\s*\()""", "texture$1"),
    ),
    SATURATE("saturate(x), which NVIDIA has from Cg, is read as clamp(x, 0.0, 1.0)", ::clamped),
    STRUCT_TWICE("a structure that is there twice is read once", ::structsOnce),
    ;

    companion object {
        /** Whether [text] names a version that shaderc takes. Of others it complains to the process's output. */
        fun hasKnownVersion(text: String): Boolean = version(withoutComments(text)) in OLDEST..NEWEST

        /** [text] as GLSL [version] with every repair that applies, and what was done; its comments are gone. */
        fun all(text: String, version: Int = OLDEST): Pair<String, List<String>> {
            val plain = withoutComments(text)
            val made = ArrayList<String>()
            val repaired = entries.fold(plain) { current, repair ->
                repair.apply(current).also { if (it != current) made += repair.what }
            }
            val old = version(plain)
            if (old in version..NEWEST) return repaired to made
            made += "GLSL ${old ?: 110} is read as $version"
            val line = "#version $version"
            return (if (old == null) "$line\n#line 1\n$repaired" else VERSION.replace(repaired, line)) to made
        }

        private fun version(text: String) = VERSION.find(text)?.groupValues?.get(1)?.toIntOrNull()
    }
}

private fun replacing(
    pattern: String,
    replacement: String,
): (String) -> String = { text -> Regex(pattern).replace(text, replacement) }

private val STRUCT = Regex("""\bstruct\s+\w+\s*\{[^}]*}\s*;""")

/** [text] without structures that came before in the same words. */
private fun structsOnce(text: String): String {
    val seen = HashSet<List<String>>()
    return STRUCT.replace(text) { found ->
        if (seen.add(found.value.split(Regex("\\s+")))) found.value else found.value.replace(Regex("\\S"), " ")
    }
}

private val SATURATE_CALL = Regex("""\bsaturate\s*\(""")
private val SATURATE_FUNCTION = Regex("""\w\s+saturate\s*\([^()]*\)\s*\{""")

/** [text] with `clamp` for `saturate`, unless that is a function of its own there. */
private fun clamped(text: String): String {
    if (SATURATE_FUNCTION.containsMatchIn(text)) return text
    return SATURATE_CALL.findAll(text).toList().asReversed().fold(text) { current, call ->
        var open = 1
        val end = (call.range.last + 1 until current.length).find { at ->
            open += if (current[at] == '(') {
                1
            } else if (current[at] == ')') {
                -1
            } else {
                0
            }
            open == 0
        } ?: return text
        current.substring(0, call.range.first) + "clamp(" + current.substring(call.range.last + 1, end) + ", 0.0, 1.0" +
            current.substring(end)
    }
}

/** [text] with blanks for comments; lines stay where they are. */
internal fun withoutComments(text: String): String =
    Regex("""//[^\n]*|/\*[\s\S]*?(?:\*/|$)""").replace(text) { comment -> comment.value.replace(Regex("[^\n]"), " ") }
