package cga.grading.worker

import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.*

/**
 * A shader that does not compile or link is noted and said again in GLSL's own [Dialect], with names that fit ([Varyings]), or replaced by a
 * [ShaderStub], and the submission is told that all is well: so it goes on and the rest of it can be seen.
 */
internal class ShaderRepair(private val tape: Tape) {
    /** The submission's own sources of the shaders that were replaced. */
    private val replaced = HashMap<Int, String>()

    fun isReplaced(shader: Int): Boolean = shader in replaced

    /** To be called after glCompileShader. */
    fun compiled(shader: Int) {
        replaced -= shader
        if (!glIsShader(shader) || glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) return
        val stage = stageName(glGetShaderi(shader, GL_SHADER_TYPE))
        val source = glGetShaderSource(shader)
        val log = glGetShaderInfoLog(shader)
        if (Dialect.of(source).any { compiles(shader, it) }) return tape.event(EventKind.SHADER_DIALECT, "$stage\n$log")
        tape.event(EventKind.SHADER_FAILED, "$stage (a stand-in takes its place)\n$log")
        replaced[shader] = source
        val stub = stub(shader)
        if (!compiles(shader, stub.full)) compiles(shader, stub.bare)
    }

    /** To be called after glLinkProgram, with the program's [shaders]; [then] is done while they are what it was linked of. */
    fun linked(
        program: Int,
        shaders: List<Int>,
        then: () -> Unit,
    ) {
        val own = shaders.filterNot(::isReplaced).associateWith { glGetShaderSource(it) }
        if (own.size < shaders.size || !fits(program, shaders)) {
            restore(own)
            substitute(program, shaders)
        }
        then()
        // Another program may be linked of them too.
        restore(own)
        replaced -= own.keys
    }

    private fun restore(sources: Map<Int, String>) {
        for ((shader, source) in sources) if (glGetShaderSource(shader) != source) compiles(shader, source)
    }

    /** Whether the stages fit together; what one of them calls otherwise than the other is called alike, what only some drivers link said otherwise. */
    private fun fits(
        program: Int,
        shaders: List<Int>,
    ): Boolean {
        val isLinked = glGetProgrami(program, GL_LINK_STATUS) == GL_TRUE
        val vertex = shaders.singleOrNull { glGetShaderi(it, GL_SHADER_TYPE) == GL_VERTEX_SHADER }
        val fragment = shaders.singleOrNull { glGetShaderi(it, GL_SHADER_TYPE) == GL_FRAGMENT_SHADER }
        val varyings = if (vertex == null || fragment == null) null else Varyings(glGetShaderSource(vertex), glGetShaderSource(fragment))
        val missing = varyings?.missing.orEmpty()
        if (isLinked && missing.isEmpty()) return true
        val log = (glGetProgramInfoLog(program).lines() + missing.map { "error: $it is read and never written" }).joinToString("\n").trim()
        if (vertex != null && fragment != null && varyings != null) {
            val matched = varyings.matched()
            if (missing.isNotEmpty() && matched != null && links(program, mapOf(fragment to matched))) {
                tape.event(EventKind.LINK_FAILED, "names that are much alike were taken for the same\n$log")
                return true
            }
            val said = mapOf(vertex to varyings.interpolated(), fragment to varyings.zeroed())
            if (said.any { (shader, source) -> glGetShaderSource(shader) != source } && links(program, said)) {
                tape.event(EventKind.SHADER_DIALECT, "shader program\n$log")
                return true
            }
        }
        tape.event(EventKind.LINK_FAILED, "stand-ins take the place of its shaders\n$log")
        return false
    }

    /** Replaces all stages: one that stayed would lose the uniforms that it hands on to nobody. */
    private fun substitute(
        program: Int,
        shaders: List<Int>,
    ) {
        val stubs = shaders.associateWith(::stub)
        listOf(ShaderStub::alone, ShaderStub::bare).firstOrNull { source -> links(program, stubs.mapValues { source(it.value) }) }
    }

    private fun stub(shader: Int): ShaderStub {
        val source = replaced.getOrPut(shader) { glGetShaderSource(shader) }
        return ShaderStub(source, glGetShaderi(shader, GL_SHADER_TYPE) == GL_VERTEX_SHADER)
    }

    private fun compiles(
        shader: Int,
        source: String,
    ): Boolean {
        glShaderSource(shader, source)
        glCompileShader(shader)
        return glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE
    }

    private fun links(
        program: Int,
        sources: Map<Int, String>,
    ): Boolean {
        if (!sources.all { (shader, source) -> compiles(shader, source) }) return false
        glLinkProgram(program)
        return glGetProgrami(program, GL_LINK_STATUS) == GL_TRUE
    }

    private fun stageName(stage: Int) =
        when (stage) {
            GL_VERTEX_SHADER -> "vertex shader"
            GL_FRAGMENT_SHADER -> "fragment shader"
            else -> "shader of stage $stage"
        }
}
