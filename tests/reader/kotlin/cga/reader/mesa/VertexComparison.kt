package cga.reader.mesa

import cga.reader.numbersFor
import cga.reader.run.Machine
import cga.reader.shader.Kind
import cga.reader.shader.Shader
import cga.reader.shader.Slot
import cga.reader.tape.Tape
import org.lwjgl.opengl.GL33C.*
import kotlin.random.Random

/** OpenGL gives at least so many numbers a vertex back. */
private const val MOST_NUMBERS = 64
private const val EMPTY_FRAGMENT = "#version 330 core\nvoid main() {}\n"

/** What the vertex shader [text] makes of random attributes and uniforms: by the driver's transform feedback, and read. */
internal fun compareVertices(file: String, text: String, shader: Shader, points: Int, random: Random): Comparison {
    val comparison = Comparison()
    // Those of GLSL's own that are not written have no value.
    val outputs = shader.outputs.filter { !it.name.startsWith("gl_") || it.name == "gl_Position" }
    var rest = outputs
    while (rest.isNotEmpty()) {
        var numbers = 0
        val group = rest.takeWhile { output -> (numbers + output.size <= MOST_NUMBERS).also { numbers += output.size } }
        rest = rest.drop(group.size)
        val names = group.map { it.name }.toTypedArray()
        GlProgram(text, EMPTY_FRAGMENT) { glTransformFeedbackVaryings(it, names, GL_INTERLEAVED_ATTRIBS) }.use { program ->
            repeat(points) { comparison += comparePoint("$file, vertex $it", program, shader, group, random) }
        }
    }
    return comparison
}

private fun comparePoint(what: String, program: GlProgram, shader: Shader, outputs: List<Slot>, random: Random): Comparison {
    val comparison = Comparison()
    val machine = Machine(shader)
    for (slot in shader.uniforms.filter { it.kind != Kind.SAMPLER }) {
        random.numbersFor(slot).let {
            machine[slot] = it
            program.set(slot, it)
        }
    }
    for (slot in shader.inputs.filter { !it.name.startsWith("gl_") }) {
        random.numbersFor(slot).let {
            machine[slot] = it
            setAttribute(program.id, slot, it)
        }
    }
    val tape = Tape(shader)
    val outcome = machine.run(tape)
    val drawn = feedback(outputs.sumOf { it.size })
    var at = 0
    for (output in outputs) {
        val numbers = DoubleArray(output.size) {
            if (output.kind ==
                Kind.FLOAT
            ) {
                drawn[at + it].toDouble()
            } else {
                drawn[at + it].toRawBits().toDouble()
            }
        }
        comparison.add(what, machine[output], tape, outcome, output.name, numbers)
        at += output.size
    }
    return comparison
}

private fun setAttribute(program: Int, slot: Slot, numbers: DoubleArray) {
    val location = glGetAttribLocation(program, slot.name)
    if (location < 0) return
    for (column in 0 until slot.columns) {
        val of = FloatArray(4) { if (it < slot.rows) numbers[column * slot.rows + it].toFloat() else 0f }
        if (slot.kind == Kind.FLOAT) {
            glVertexAttrib4fv(location + column, of)
        } else {
            glVertexAttribI4iv(location + column, IntArray(4) { of[it].toInt() })
        }
    }
}

/** The numbers of one vertex, whose attributes are set. */
private fun feedback(count: Int): FloatArray {
    val buffer = glGenBuffers()
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer)
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, FloatArray(count), GL_STREAM_READ)
    glEnable(GL_RASTERIZER_DISCARD)
    glBeginTransformFeedback(GL_POINTS)
    glDrawArrays(GL_POINTS, 0, 1)
    glEndTransformFeedback()
    glDisable(GL_RASTERIZER_DISCARD)
    val numbers = FloatArray(count)
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, numbers)
    glDeleteBuffers(buffer)
    return numbers
}
