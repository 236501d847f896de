package cga.exercise.components.shader

import org.lwjgl.opengl.GL33C.*

/** Compiles and links GLSL, and turns the driver's log into messages with the file's name and the line's text. */
internal object ShaderCompiler {
    /** A linked program of the two sources, owned by the caller. Throws [ShaderError]; nothing is left behind then. */
    fun link(
        vertexSource: ShaderSource,
        fragmentSource: ShaderSource,
    ): Int {
        val vertex = compile(GL_VERTEX_SHADER, vertexSource)
        val fragment =
            try {
                compile(GL_FRAGMENT_SHADER, fragmentSource)
            } catch (e: ShaderError) {
                glDeleteShader(vertex)
                throw e
            }
        val program = glCreateProgram()
        glAttachShader(program, vertex)
        glAttachShader(program, fragment)
        glLinkProgram(program)
        glDeleteShader(vertex)
        glDeleteShader(fragment)
        if (glGetProgrami(program, GL_LINK_STATUS) == GL_FALSE) {
            val log = glGetProgramInfoLog(program)
            glDeleteProgram(program)
            throw ShaderError("shaders ${vertexSource.path} and ${fragmentSource.path} do not fit together: ${log.trim()}")
        }
        return program
    }

    private fun compile(
        stage: Int,
        source: ShaderSource,
    ): Int {
        val shader = glCreateShader(stage)
        glShaderSource(shader, source.text)
        glCompileShader(shader)
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) {
            val log = glGetShaderInfoLog(shader)
            glDeleteShader(shader)
            throw ShaderError(explain(source, log))
        }
        return shader
    }

    // Mesa "0:12(5): error: …", NVIDIA "0(12) : error …", AMD, Intel and Apple "ERROR: 0:12: …".
    private val LOCATION = Regex("""^(?:(?:ERROR|WARNING):\s*)?\d+[:(](\d+)\)?(?:\((\d+)\))?\s*:\s*(.*)$""")

    /** The driver's [log] about [source] as `file:line: message`, each with its source line below. */
    fun explain(
        source: ShaderSource,
        log: String,
    ): String = log.trim().lines().filter(String::isNotBlank).joinToString("\n") { explainEntry(source, it.trim()) }

    private fun explainEntry(
        source: ShaderSource,
        entry: String,
    ): String {
        val (number, _, message) = LOCATION.find(entry)?.destructured ?: return "${source.path}: $entry"
        val line = source.line(number.toInt()) ?: return "${source.path}:$number: $message"
        return "${line.file}:${line.number}: $message\n    ${line.text.trim()}"
    }
}
