package cga.reader.glsl

import cga.reader.Problem
import cga.reader.shader.Stage
import org.lwjgl.system.MemoryUtil
import org.lwjgl.util.shaderc.Shaderc.*

/** What shaderc made of a shader: the SPIR-V, or the problems. */
internal class Compiled(
    val binary: ByteArray?,
    val problems: List<Problem>,
    val repairs: List<String> = emptyList(),
)

/** GLSL to SPIR-V, by shaderc. */
internal object GlslCompiler {
    /** Its messages: `file:12: error: …`. */
    private val MESSAGE = Regex("""^(.*):(\d+): error: (.*)$""")

    /**
     * Compiles [text] as it is; where that fails, repaired; and where that fails, as the newest GLSL, which allows what some drivers allow in
     * older ones: a semicolon too many, locations of uniforms, arrays of arrays. The problems are those of the first attempt.
     */
    fun compile(file: String, text: String, stage: Stage): Compiled {
        val plain = if (Repair.hasKnownVersion(text)) compileAsIs(file, text, stage) else null
        if (plain?.binary != null) return plain
        val attempts = sequenceOf(Repair.all(text), Repair.all(text, NEWEST)).map { (repaired, repairs) ->
            compileAsIs(file, repaired, stage).let { Compiled(it.binary, it.problems, repairs) }
        }
        return attempts.find { it.binary != null } ?: plain ?: attempts.first()
    }

    private fun compileAsIs(file: String, text: String, stage: Stage): Compiled {
        val options = shaderc_compile_options_initialize()
        // Not as a Kotlin text: LWJGL has only 64 KB for those.
        val source = MemoryUtil.memUTF8(text, false)
        val name = MemoryUtil.memUTF8(file)
        val entry = MemoryUtil.memUTF8("main")
        try {
            shaderc_compile_options_set_target_env(options, shaderc_target_env_opengl, shaderc_env_version_opengl_4_5)
            shaderc_compile_options_set_auto_map_locations(options, true)
            shaderc_compile_options_set_auto_bind_uniforms(options, true)
            shaderc_compile_options_set_generate_debug_info(options)
            shaderc_compile_options_set_optimization_level(options, shaderc_optimization_level_zero)
            val kind = if (stage == Stage.VERTEX) shaderc_glsl_vertex_shader else shaderc_glsl_fragment_shader
            val result = shaderc_compile_into_spv(compiler, source, kind, name, entry, options)
            try {
                if (shaderc_result_get_compilation_status(result) != shaderc_compilation_status_success) {
                    return Compiled(null, problems(file, shaderc_result_get_error_message(result).orEmpty()))
                }
                val bytes = checkNotNull(shaderc_result_get_bytes(result)) { "shaderc gave no module for $file" }
                return Compiled(ByteArray(bytes.remaining()).also { bytes.get(it) }, emptyList())
            } finally {
                shaderc_result_release(result)
            }
        } finally {
            listOf(source, name, entry).forEach(MemoryUtil::memFree)
            shaderc_compile_options_release(options)
        }
    }

    private fun problems(file: String, messages: String): List<Problem> {
        val found = messages.lines().mapNotNull { MESSAGE.find(it) }.map { Problem(file, it.groupValues[2].toInt(), it.groupValues[3]) }
        return found.ifEmpty { listOf(Problem(file, 0, messages.trim())) }
    }

    private const val NEWEST = 460

    /** For good: with the last one shaderc forgets GLSL's built-in functions, which takes longer to read than a shader. */
    private val compiler by lazy { shaderc_compiler_initialize() }
}
