package cga.exercise.components.shader

import cga.framework.ShaderComplaint
import cga.framework.ShaderLog
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

    /** The driver's [log] about [source] as `file:line: message`, each with its source line below. */
    fun explain(
        source: ShaderSource,
        log: String,
    ): String = ShaderLog.read(source.text.lines(), log).joinToString("\n") { explain(source, it) }

    private fun explain(
        source: ShaderSource,
        complaint: ShaderComplaint,
    ): String {
        val number = complaint.line ?: return "${source.path}: ${complaint.message}"
        val line = source.line(number) ?: return "${source.path}:$number: ${complaint.message}"
        val before = complaint.unended?.let(source::line)
        val or = before?.let { "\nor already line ${it.number}, which does not end in a semicolon:\n    ${it.text.trim()}" }.orEmpty()
        return "${line.file}:${line.number}: ${complaint.message}\n    ${line.text.trim()}$or"
    }
}
