package cga.reader.run

import cga.reader.shader.Slot
import cga.reader.shader.Stage

/**
 * Hands what a vertex has put out to the fragment shader of this machine, by name, as at that very vertex. Returns the inputs that the
 * vertex shader does not write; some drivers take such a pair.
 */
public fun Machine.takeVaryings(vertex: Machine): List<Slot> {
    require(
        shader.stage == Stage.FRAGMENT && vertex.shader.stage == Stage.VERTEX,
    ) { "varyings go from a vertex shader to a fragment shader" }
    val written = vertex.shader.outputs.associateBy { it.name }
    val (fed, unfed) = shader.inputs.filter { it.location != null }.partition { written[it.name]?.size == it.size }
    for (input in fed) this[input] = vertex[written.getValue(input.name)]
    return unfed
}
