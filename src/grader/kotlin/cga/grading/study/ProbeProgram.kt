package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedProgram
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/** A uniform that the probed program reads. @param text what the submission calls it. */
internal class ActiveUniform(
    val name: String,
    val type: Int,
    val location: Int,
    val text: String,
) {
    val components: Int = componentsOf(type)

    /** Whether it reads a 2D texture. */
    val isSampler: Boolean get() = type == GL_SAMPLER_2D

    private fun componentsOf(type: Int) =
        when (type) {
            GL_FLOAT_VEC2, GL_INT_VEC2, GL_BOOL_VEC2 -> 2
            GL_FLOAT_VEC3, GL_INT_VEC3, GL_BOOL_VEC3 -> 3
            GL_FLOAT_VEC4, GL_INT_VEC4, GL_BOOL_VEC4, GL_FLOAT_MAT2 -> 4
            GL_FLOAT_MAT3 -> 9
            GL_FLOAT_MAT4 -> 16
            else -> 1
        }
}

/**
 * A submission's program, edited so that every vertex lands on a pixel of our choice and keeps everything else that it computes.
 *
 * Its own `main` still runs; where it puts the vertex is written to `cga_clip` for transform feedback. Needs a current context.
 * Throws [InputError] with the driver's log when the program does not compile.
 *
 * @param depthMaps samplers that read depths: they see nothing near, so that nothing is in shadow.
 */
internal class ProbeProgram(
    captured: CapturedProgram,
    isDeep: Boolean = false,
    private val depthMaps: Set<String> = emptySet(),
) : AutoCloseable {
    private val vertex = LiftedConstants.of(captured.vertexSource, "cga_v", isDeep)
    private val fragment = LiftedConstants.of(captured.fragmentSource, "cga_f", isDeep)
    private val isLifted: Boolean
    val id: Int

    /** Where [ProbeRig] feeds the pixel. */
    val pixelLocation: Int = (0..15).first { it !in captured.attributes.values }
    val uniforms: List<ActiveUniform>

    /** Factors of vectors that are neither constants nor uniforms, where the program was lifted deeply; not among [uniforms]. */
    val deep: List<ActiveUniform>

    /** Values of the constants that became uniforms. */
    val constants: Map<String, FloatArray>
    private val sent = HashMap<String, FloatArray>()

    init {
        val lifted = runCatching { link(captured, vertex.source, fragment.source) }.getOrNull()
        isLifted = lifted != null
        id = lifted ?: link(captured, captured.vertexSource, captured.fragmentSource)
        constants = if (isLifted) vertex.values + fragment.values else emptyMap()
        val (lifts, own) = activeUniforms().partition { it.name in vertex.deep || it.name in fragment.deep }
        uniforms = own
        deep = lifts
        glUseProgram(id)
        val cubes = uniforms.filter { it.type == GL_SAMPLER_CUBE }
        (samplers + depths + cubes).forEachIndexed { unit, sampler -> glUniform1i(sampler.location, unit) }
    }

    /** All values of uniforms in [draw], those of the lifted constants among them. */
    fun values(draw: CapturedDraw): Map<String, FloatArray> = constants + draw.uniforms.associate { it.name to it.numbers }

    /** The samplers of coloured 2D textures; number i reads texture unit i. Those of cube maps find nothing, which is black. */
    val samplers: List<ActiveUniform> get() = uniforms.filter { it.isSampler && it.name !in depthMaps }

    /** The samplers of depths; they read the units after those of [samplers]. */
    val depths: List<ActiveUniform> get() = uniforms.filter { it.isSampler && it.name in depthMaps }

    /** Names of the 4 × 4 matrices. */
    val matrices: List<String> get() = uniforms.filter { it.type == GL_FLOAT_MAT4 }.map { it.name }

    /** Sets every uniform that [values] knows, the program being in use. */
    fun send(values: Map<String, FloatArray>) {
        for (uniform in uniforms + deep) {
            val value = values[uniform.name] ?: continue
            if (uniform.isSampler || uniform.type == GL_SAMPLER_CUBE || sent[uniform.name].contentEquals(value)) continue
            send(uniform, value)
            sent[uniform.name] = value
        }
    }

    override fun close(): Unit = glDeleteProgram(id)

    private fun send(
        uniform: ActiveUniform,
        value: FloatArray,
    ) {
        when (uniform.type) {
            GL_FLOAT -> glUniform1fv(uniform.location, value)
            GL_FLOAT_VEC2 -> glUniform2fv(uniform.location, value)
            GL_FLOAT_VEC3 -> glUniform3fv(uniform.location, value)
            GL_FLOAT_VEC4 -> glUniform4fv(uniform.location, value)
            GL_FLOAT_MAT2 -> glUniformMatrix2fv(uniform.location, false, value)
            GL_FLOAT_MAT3 -> glUniformMatrix3fv(uniform.location, false, value)
            GL_FLOAT_MAT4 -> glUniformMatrix4fv(uniform.location, false, value)
            GL_UNSIGNED_INT -> glUniform1ui(uniform.location, value[0].toInt())
            GL_INT, GL_BOOL -> glUniform1i(uniform.location, value[0].toInt())
            GL_INT_VEC2, GL_BOOL_VEC2 -> glUniform2iv(uniform.location, value.toInts())
            GL_INT_VEC3, GL_BOOL_VEC3 -> glUniform3iv(uniform.location, value.toInts())
            GL_INT_VEC4, GL_BOOL_VEC4 -> glUniform4iv(uniform.location, value.toInts())
        }
    }

    private fun FloatArray.toInts() = IntArray(size) { this[it].toInt() }

    private fun link(
        captured: CapturedProgram,
        vertexSource: String,
        fragmentSource: String,
    ): Int {
        val program = glCreateProgram()
        val shaders =
            listOf(
                compile(GL_VERTEX_SHADER, withEvenPowers(instrumented(vertexSource))),
                compile(GL_FRAGMENT_SHADER, withEvenPowers(fragmentSource)),
            )
        shaders.forEach { glAttachShader(program, it) }
        for ((name, location) in captured.attributes) glBindAttribLocation(program, location, name)
        glBindAttribLocation(program, pixelLocation, "cga_pixel")
        for ((name, color) in captured.outputs) glBindFragDataLocation(program, color, name)
        glTransformFeedbackVaryings(program, "cga_clip", GL_INTERLEAVED_ATTRIBS)
        glLinkProgram(program)
        shaders.forEach(::glDeleteShader)
        if (glGetProgrami(program, GL_LINK_STATUS) != GL_TRUE) {
            val log = glGetProgramInfoLog(program, LOG_LENGTH)
            glDeleteProgram(program)
            throw InputError("the program does not link when probed: $log")
        }
        return program
    }

    private fun compile(
        stage: Int,
        source: String,
    ): Int {
        val shader = glCreateShader(stage)
        glShaderSource(shader, source)
        glCompileShader(shader)
        if (glGetShaderi(shader, GL_COMPILE_STATUS) != GL_TRUE) {
            val log = glGetShaderInfoLog(shader, LOG_LENGTH)
            glDeleteShader(shader)
            throw InputError("a shader does not compile when probed: $log")
        }
        return shader
    }

    private fun instrumented(source: String): String =
        LiftedConstants.afterVersion(
            LiftedConstants.withoutComments(source),
            "in vec2 cga_pixel; out vec4 cga_clip;\n#define main cga_student_main",
        ) + "\n#undef main\nvoid main() { cga_student_main(); cga_clip = gl_Position; gl_Position = vec4(cga_pixel, 0.0, 1.0); }\n"

    /**
     * pow of a negative base, which GLSL leaves open and drivers make NaN of, becomes that of the base without its sign: a lobe to be seen. A
     * root, as a gamma is one, keeps the sign, so that it can be undone.
     */
    private fun withEvenPowers(source: String): String =
        LiftedConstants.afterVersion(
            source,
            "float cga_sign(float x, float y) { return y < 1.0 ? sign(x) : 1.0; } " +
                (2..4).map { "vec$it" }.joinToString(" ") {
                    "$it cga_sign($it x, $it y) { return mix($it(1.0), sign(x), $it(lessThan(y, $it(1.0)))); }"
                } +
                listOf("float", "vec2", "vec3", "vec4").joinToString("") {
                    " $it cga_pow($it x, $it y) { return cga_sign(x, y) * pow(abs(x), y); }"
                } + "\n#define pow cga_pow",
        )

    private fun activeUniforms(): List<ActiveUniform> =
        MemoryStack.stackPush().use { stack ->
            val size = stack.mallocInt(1)
            val type = stack.mallocInt(1)
            (0 until glGetProgrami(id, GL_ACTIVE_UNIFORMS)).flatMap { index ->
                val name = glGetActiveUniform(id, index, size, type)
                val base = name.removeSuffix("[0]")
                val names = if (name.endsWith("[0]")) List(size[0].coerceAtMost(MAX_ELEMENTS)) { "$base[$it]" } else listOf(name)
                names.mapNotNull { element ->
                    val location = glGetUniformLocation(id, element)
                    if (location <
                        0
                    ) {
                        null
                    } else {
                        ActiveUniform(element, type[0], location, vertex.texts[element] ?: fragment.texts[element] ?: element)
                    }
                }
            }
        }

    private companion object {
        const val LOG_LENGTH = 2000
        const val MAX_ELEMENTS = 64
    }
}
