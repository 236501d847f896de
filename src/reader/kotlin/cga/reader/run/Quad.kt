package cga.reader.run

import cga.reader.shader.Shader
import cga.reader.tape.Tape

/**
 * Four neighbouring invocations of a fragment shader: left and right, the lower two first. They run side by side, so that what differs
 * between them is what `dFdx` and `dFdy` are, and what chooses the level of a texture.
 *
 * An invocation that has ended, or is elsewhere, has no difference to give; it counts as equal then, as GLSL leaves that open.
 */
public class Quad(shader: Shader) {
    /** To set the inputs of; uniforms and textures of each. */
    public val machines: List<Machine> = List(4) { Machine(shader).apply { isInQuad = true } }

    /** How each ends. [tapes] are none or four. */
    public fun run(tapes: List<Tape> = emptyList(), steps: Long = Machine.MAX_STEPS): List<Outcome> {
        val outcomes = arrayOfNulls<Outcome>(4)
        for ((i, machine) in machines.withIndex()) {
            machine.begin(tapes.getOrNull(i), steps)
            outcomes[i] = machine.goOn()
        }
        while (true) {
            val halted = outcomes.indices.filter { outcomes[it] == null }
            // Who is behind comes first, until all stand where the last of them does.
            val at = halted.minOfOrNull { machines[it].haltedAt } ?: break
            val together = halted.filter { machines[it].haltedAt == at }
            val gradients = together.map { i -> difference(i xor 1, i, together) to difference(i xor 2, i, together) }
            for ((i, gradient) in together.zip(gradients)) outcomes[i] = machines[i].resume(gradient.first, gradient.second)
        }
        return outcomes.map(::checkNotNull)
    }

    /** Right minus left, or upper minus lower, whichever of [other] and [i] is which. */
    private fun difference(other: Int, i: Int, together: List<Int>): DoubleArray {
        val mine = machines[i]
        val cells = mine.exchanged
        if (other !in together) return DoubleArray(cells.size)
        val (low, high) = if (other < i) machines[other] to mine else mine to machines[other]
        return DoubleArray(cells.size) { high.cells[cells[it]] - low.cells[cells[it]] }
    }
}
