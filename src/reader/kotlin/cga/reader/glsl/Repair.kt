package cga.reader.glsl

import cga.reader.shader.Stage

/** The version that a shader names. */
internal val VERSION = Regex("""(?m)^\s*#\s*version\s+(\d+)""")

/** A way of writing that drivers take and the compiler does not, and how it is put otherwise, on the same line. */
internal enum class Repair(
    private val what: String,
    private val pattern: Regex,
    private val put: (MatchResult, Stage) -> String,
) {
    OLD_VERSION("GLSL before 3.30 is read as 3.30", Regex("""(?m)^(\s*#\s*version\s+)(140|150)\b"""), { found, _ -> found.groupValues[1] + "330" }),
    FLOAT_SUFFIX("1f is read as 1.0f", Regex("""(?<![\w.])(\d+)[fF]\b"""), { found, _ -> found.groupValues[1] + ".0f" }),
    OLD_TEXTURE(
        "texture2D and its like are read as texture",
        Regex("""\b(?:texture|shadow)(?:1D|2D|3D|Cube)((?:Proj)?(?:Lod|Grad)?)(?=\s*\()"""),
        { found, _ -> "texture" + found.groupValues[1] },
    ),
    ;

    companion object {
        /** [text] with every repair that applies, and what was done. Comments are gone. */
        fun all(
            text: String,
            stage: Stage,
        ): Pair<String, List<String>> {
            val made = ArrayList<String>()
            val repaired = entries.fold(withoutComments(text)) { current, repair ->
                repair.pattern.replace(current) { repair.put(it, stage) }.also { if (it != current) made += repair.what }
            }
            return repaired to made
        }
    }
}

/** [text] with blanks for comments; lines stay where they are. */
internal fun withoutComments(text: String): String =
    Regex("""//[^\n]*|/\*[\s\S]*?(?:\*/|$)""").replace(text) { comment -> comment.value.replace(Regex("[^\n]"), " ") }
