package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedProgram
import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/**
 * The submission's shaders and programs. One that does not compile or link is noted and said again in GLSL's own [Dialect], or replaced by
 * a [ShaderStub], and the submission is told that all is well: so it goes on and the rest of it can be seen.
 */
internal class Programs(private val tape: Tape) {
    private val linked = HashMap<Int, Linked>()
    private val outputs = HashMap<Int, MutableMap<String, Int>>()

    /** The submission's own sources of the shaders that were replaced. */
    private val replaced = HashMap<Int, String>()

    /** A program after its last link; [number] on the tape is null when a capture cannot hold it. */
    class Linked(
        val number: Int?,
        val attributes: Map<String, Int>,
        val uniforms: List<Uniform>,
    ) {
        /** Uniforms that were asked for, by location. */
        val asked: MutableMap<Int, String> = HashMap()

        /** The locations that the vertex shader reads. */
        val locations: Set<Int> = attributes.values.toSet()
    }

    fun bindOutput(
        program: Int,
        number: Int,
        name: String,
    ) {
        outputs.getOrPut(program) { LinkedHashMap() }[name] = number
    }

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

    /** To be called after glLinkProgram. */
    fun linked(program: Int) {
        linked -= program
        if (!glIsProgram(program)) return
        val shaders = shaders(program)
        val own = shaders.filter { it !in replaced }
        if (own.size < shaders.size || !fits(program, shaders)) substitute(program, shaders)
        if (glGetProgrami(program, GL_LINK_STATUS) == GL_TRUE) linked[program] = describe(program, shaders)
        // Another program may be linked of them too.
        own.forEach { shader -> replaced.remove(shader)?.let { compiles(shader, it) } }
    }

    /** Whether the stages fit together; what one of them calls otherwise than the other is called alike. */
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
        val log = "${glGetProgramInfoLog(program)}\n${missing.joinToString("\n") { "$it is read and never written" }}"
        val matched = varyings?.matched()
        if (fragment != null && matched != null && links(program, mapOf(fragment to matched))) {
            tape.event(EventKind.LINK_FAILED, "names that are much alike were taken for the same\n${log.trim()}")
            return true
        }
        tape.event(EventKind.LINK_FAILED, "stand-ins take the place of its shaders\n${log.trim()}")
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

    /** The [program] as it was last linked, null for what is none. */
    fun find(program: Int): Linked? = linked[program]

    /** The name of the uniform at [location] where it was asked of a program other than [program], and never of this one. */
    fun foreign(
        program: Int,
        location: Int,
    ): String? {
        if (linked[program]?.asked?.containsKey(location) == true) return null
        return linked.entries.firstNotNullOfOrNull { (other, it) -> it.asked[location].takeIf { other != program } }
    }

    private fun describe(
        program: Int,
        shaders: List<Int>,
    ): Linked {
        val attributes = attributes(program)
        val vertex = shaders.filter { glGetShaderi(it, GL_SHADER_TYPE) == GL_VERTEX_SHADER }
        val fragment = shaders.filter { glGetShaderi(it, GL_SHADER_TYPE) == GL_FRAGMENT_SHADER }
        val sources = (vertex + fragment).map { glGetShaderSource(it) }
        val uniforms = Uniforms.of(program, tape)
        val refusal =
            when {
                vertex.size != 1 || fragment.size != 1 || shaders.size != 2 -> "a program that is not one vertex and one fragment shader"
                sources.any { it.toByteArray().size > CaptureLimits.SOURCE } -> "a shader of ${sources.maxOf { it.length }} characters"
                attributes.size > CaptureLimits.ATTRIBUTES || attributes.values.any { it >= CaptureLimits.ATTRIBUTES } ->
                    "a program with ${attributes.size} attributes"
                uniforms.size > CaptureLimits.UNIFORMS -> "a program with ${uniforms.size} uniforms"
                else -> null
            }
        if (refusal != null) tape.event(EventKind.NOT_CAPTURED, refusal)
        val bound = outputs[program].orEmpty().filter { (name, number) -> number > 0 && glGetFragDataLocation(program, name) == number }
        val number =
            if (refusal != null) {
                null
            } else {
                tape.add(CapturedProgram(sources[0], sources[1], attributes, bound, shaders.any { it in replaced }))
            }
        return Linked(number, attributes, uniforms)
    }

    private fun attributes(program: Int): Map<String, Int> =
        MemoryStack.stackPush().use { stack ->
            val size = stack.mallocInt(1)
            val type = stack.mallocInt(1)
            (0 until glGetProgrami(program, GL_ACTIVE_ATTRIBUTES))
                .associate { glGetActiveAttrib(program, it, size, type).let { name -> name to glGetAttribLocation(program, name) } }
                .filterValues { it >= 0 }
        }

    private fun shaders(program: Int): List<Int> {
        val names = IntArray(glGetProgrami(program, GL_ATTACHED_SHADERS))
        if (names.isNotEmpty()) glGetAttachedShaders(program, null, names)
        return names.toList()
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
