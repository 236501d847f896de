package cga.framework

/**
 * What OpenGL's compiler says of one line of a shader.
 *
 * @param line from 1, null where it names none.
 * @param unended the line before it that could lack its semicolon: compilers name the next one. Null where there is none.
 */
public class ShaderComplaint(
    public val line: Int?,
    public val message: String,
    public val unended: Int?,
)

/** Reads the logs of OpenGL's compilers. */
public object ShaderLog {
    // Mesa "0:12(5): error: …", NVIDIA "0(12) : error …", AMD, Intel and Apple "ERROR: 0:12: …".
    private val LOCATION = Regex("""^(?:(?:ERROR|WARNING):\s*)?\d+[:(](\d+)\)?(?:\((\d+)\))?\s*:\s*(.*)$""")

    /** What the [log] says of a shader of these [lines], from top to bottom. */
    public fun read(
        lines: List<String>,
        log: String,
    ): List<ShaderComplaint> =
        log.trim().lines().filter(String::isNotBlank).map { entry ->
            val (line, _, message) = LOCATION.find(entry.trim())?.destructured ?: return@map ShaderComplaint(null, entry.trim(), null)
            ShaderComplaint(line.toInt(), message, unended(lines, line.toInt(), message))
        }

    private fun unended(
        lines: List<String>,
        line: Int,
        message: String,
    ): Int? {
        if ("syntax error" !in message || line > lines.size + 1) return null
        val before = (minOf(line - 2, lines.lastIndex) downTo 0).firstOrNull { code(lines[it]).isNotEmpty() } ?: return null
        val code = code(lines[before])
        return if (code.last() in ENDS || code.startsWith('#')) null else before + 1
    }

    private fun code(line: String) = line.substringBefore("//").trim()

    /** After these nothing is missing. */
    private const val ENDS = ";{},(+-*/=<>&|?:"
}
