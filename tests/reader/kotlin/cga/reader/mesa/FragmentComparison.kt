package cga.reader.mesa

import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.reader.OneColor
import cga.reader.float
import cga.reader.glsl.GlslCompiler
import cga.reader.numbersFor
import cga.reader.run.Machine
import cga.reader.run.Outcome
import cga.reader.shader.Kind
import cga.reader.shader.Shader
import cga.reader.shader.Slot
import cga.reader.shader.Stage
import cga.reader.tape.Tape
import org.lwjgl.opengl.GL33C.*
import kotlin.random.Random

private const val NOTHING = -12345f

/** The colours of the fragment shader [text] at points with random inputs and uniforms: drawn by the driver, and read. */
internal fun compareFragments(file: String, text: String, shader: Shader, points: Int, random: Random): Comparison {
    val varyings = Varyings(checkNotNull(GlslCompiler.compile(file, text, Stage.FRAGMENT).binary))
    val comparison = Comparison()
    for (output in shader.outputs.filter { it.location != null }) {
        GlProgram(varyings.source, text) { bindOutputs(it, shader, output) }.use { program ->
            RenderTarget(points, 1, format = ColorFormat.RGBA32F).use { target ->
                comparison += drawPoints(file, program, varyings, shader, output, target, random)
            }
        }
    }
    return comparison
}

/** The output that is looked at goes to the only target. */
private fun bindOutputs(program: Int, shader: Shader, first: Slot) {
    val others = shader.outputs.filter { it.location != null && it != first }
    glBindFragDataLocation(program, 0, first.name)
    for ((i, other) in others.withIndex()) glBindFragDataLocation(program, i + 1, other.name)
}

private fun drawPoints(
    file: String,
    program: GlProgram,
    varyings: Varyings,
    shader: Shader,
    output: Slot,
    target: RenderTarget,
    random: Random,
): Comparison {
    val comparison = Comparison()
    val machine = Machine(shader)
    val tapes = List(target.width) { Tape(shader) }
    val outcomes = ArrayList<Outcome>()
    val results = ArrayList<DoubleArray>()
    target.bind()
    glClearColor(NOTHING, NOTHING, NOTHING, NOTHING)
    glClear(GL_COLOR_BUFFER_BIT)
    setSamplers(shader, machine, program, random)
    for (i in 0 until target.width) {
        for (slot in shader.uniforms.filter { it.kind != Kind.SAMPLER }) {
            random.numbersFor(slot).let {
                machine[slot] = it
                program.set(slot, it)
            }
        }
        for (slot in shader.inputs) {
            val numbers = builtIn(slot.name, i) ?: random.numbersFor(slot)
            machine[slot] = numbers
            if (!slot.name.startsWith("gl_")) program.set(slot, numbers, varyings.uniformOf(slot.name))
        }
        glUniform1f(glGetUniformLocation(program.id, Varyings.PLACE), (2 * i + 1f) / target.width - 1)
        glDrawArrays(GL_POINTS, 0, 1)
        outcomes += machine.run(tapes[i])
        results += machine[output]
    }
    val picture = target.readFloats()
    for (i in tapes.indices) {
        val drawn = DoubleArray(output.size) { picture.rgba[4 * i + it].toDouble() }
        comparison.add("$file, point $i", results[i], tapes[i], outcomes[i], output.name, drawn.takeIf { it[0] != NOTHING.toDouble() })
    }
    return comparison
}

private fun setSamplers(shader: Shader, machine: Machine, program: GlProgram, random: Random) {
    for (slot in shader.uniforms.filter { it.kind == Kind.SAMPLER }) {
        val color = OneColor(DoubleArray(4) { random.float(0.0, 1.0) })
        machine[slot] = color
        program.set(slot, color)
    }
}

/** What GLSL's own inputs are at point [i], half a pixel into it. */
private fun builtIn(name: String, i: Int): DoubleArray? =
    when (name) {
        "gl_FragCoord" -> doubleArrayOf(i + 0.5, 0.5, 0.5, 1.0)
        "gl_FrontFacing" -> doubleArrayOf(1.0)
        "gl_PointCoord" -> doubleArrayOf(0.5, 0.5)
        else -> null
    }
