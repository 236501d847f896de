package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedProgram
import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/** The submission's programs, and what each of them reads. */
internal class Programs(private val tape: Tape) {
    private val repair = ShaderRepair(tape)
    private val linked = HashMap<Int, Linked>()
    private val outputs = HashMap<Int, MutableMap<String, Int>>()

    /** A program after its last link; [number] on the tape is null when a capture cannot hold it. */
    class Linked(
        val number: Int?,
        val attributes: Map<String, Int>,
        val uniforms: List<Uniform>,
        val blocks: UniformBlocks,
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
    fun compiled(shader: Int): Unit = repair.compiled(shader)

    /** To be called after glLinkProgram. */
    fun linked(program: Int) {
        linked -= program
        if (!glIsProgram(program)) return
        val shaders = shaders(program)
        repair.linked(program, shaders) {
            if (glGetProgrami(program, GL_LINK_STATUS) == GL_TRUE) linked[program] = describe(program, shaders)
        }
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
        val plain = (vertex + fragment).map { PlainUniforms(glGetShaderSource(it)) }
        val sources = plain.map { it.source }
        val uniforms = Uniforms.of(program, tape)
        val blocks = UniformBlocks.of(program, plain, tape)
        val size = uniforms.size + blocks.members.size
        val refusal =
            when {
                vertex.size != 1 || fragment.size != 1 || shaders.size != 2 -> "a program that is not one vertex and one fragment shader"
                sources.any { it.toByteArray().size > CaptureLimits.SOURCE } -> "a shader of ${sources.maxOf { it.length }} characters"
                attributes.size > CaptureLimits.ATTRIBUTES || attributes.values.any { it >= CaptureLimits.ATTRIBUTES } ->
                    "a program with ${attributes.size} attributes"
                size > CaptureLimits.UNIFORMS -> "a program with $size uniforms"
                else -> null
            }
        if (refusal != null) tape.event(EventKind.NOT_CAPTURED, refusal)
        val bound = outputs[program].orEmpty().filter { (name, number) -> number > 0 && glGetFragDataLocation(program, name) == number }
        val number =
            if (refusal != null) {
                null
            } else {
                tape.add(CapturedProgram(sources[0], sources[1], attributes, bound, shaders.any(repair::isReplaced)))
            }
        return Linked(number, attributes, uniforms, blocks)
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
}
