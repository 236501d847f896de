package cga.reader.glsl

import cga.reader.Problem
import cga.reader.shader.Stage
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

    /** Compiles [text] as it is, and where that fails, repaired. */
    fun compile(
        file: String,
        text: String,
        stage: Stage,
    ): Compiled {
        val refusal = refusal(text)
        if (refusal != null) return Compiled(null, listOf(Problem(file, 0, refusal)))
        val plain = compileAsIs(file, text, stage)
        if (plain.binary != null) return plain
        val (repaired, repairs) = Repair.all(text, stage)
        if (repairs.isEmpty()) return plain
        val second = compileAsIs(file, repaired, stage)
        return if (second.binary == null) plain else Compiled(second.binary, emptyList(), repairs)
    }

    /** Without a version shaderc's built-in functions do not compile, and it says so at length, to the process's output. */
    private fun refusal(text: String): String? {
        val version = VERSION.find(withoutComments(text))
            ?: return "has no #version, so it is GLSL 1.10, which an OpenGL 3.3 core context does not take; a part of a shader is read with the rest"
        return if (version.groupValues[1].toInt() in VERSIONS) null else "is GLSL ${version.groupValues[1]}; what can be read is $VERSIONS"
    }

    private fun compileAsIs(
        file: String,
        text: String,
        stage: Stage,
    ): Compiled {
        val options = shaderc_compile_options_initialize()
        val compiler = shaderc_compiler_initialize()
        try {
            shaderc_compile_options_set_target_env(options, shaderc_target_env_opengl, shaderc_env_version_opengl_4_5)
            shaderc_compile_options_set_auto_map_locations(options, true)
            shaderc_compile_options_set_auto_bind_uniforms(options, true)
            shaderc_compile_options_set_generate_debug_info(options)
            shaderc_compile_options_set_optimization_level(options, shaderc_optimization_level_zero)
            val kind = if (stage == Stage.VERTEX) shaderc_glsl_vertex_shader else shaderc_glsl_fragment_shader
            val result = shaderc_compile_into_spv(compiler, text, kind, file, "main", options)
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
            shaderc_compiler_release(compiler)
            shaderc_compile_options_release(options)
        }
    }

    private fun problems(
        file: String,
        messages: String,
    ): List<Problem> {
        val found = messages.lines().mapNotNull { MESSAGE.find(it) }.map { Problem(file, it.groupValues[2].toInt(), it.groupValues[3]) }
        return found.ifEmpty { listOf(Problem(file, 0, messages.trim())) }
    }

    private val VERSIONS = 140..460
}
