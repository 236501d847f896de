package cga.grading.reading

import cga.grading.capture.CapturedProgram
import cga.reader.run.Machine
import cga.reader.run.Outcome
import cga.reader.run.Sampler
import cga.reader.run.takeVaryings
import cga.reader.shader.Kind
import cga.reader.tape.Tape

/** The attributes of a vertex, by location; those that are not given are (0, 0, 0, 1). */
internal typealias Attributes = Map<Int, DoubleArray>

/** Runs a program with any numbers: uniforms, textures of one texel, vertices. */
internal class Probe(
    val pair: ShaderPair,
    private val program: CapturedProgram,
    val keys: Keys = Keys(),
) {
    private val vertex = Machine(pair.vertex)
    private val fragment = Machine(pair.fragment)
    private val vertexTape = Tape(pair.vertex)
    private val fragmentTape = Tape(pair.fragment)
    private val inputs = pair.vertex.inputs.mapNotNull { slot -> program.attributes[slot.name]?.let { slot to it } }

    /** Locations of the attributes that the vertex shader reads, with their number of components. */
    val attributes: Map<Int, Int> = inputs.associate { (slot, location) -> location to slot.size }

    /** The location of the attribute called [name]. */
    fun location(name: String): Int? = program.attributes[name]

    /** Names of the samplers of the fragment shader. */
    val samplers: List<String> = pair.fragment.uniforms.filter { it.kind == Kind.SAMPLER }.map { it.name }

    /** Sets the uniforms in [values] that there are. */
    fun set(values: Map<String, DoubleArray>) {
        for (machine in listOf(vertex, fragment)) {
            for (slot in machine.shader.uniforms) {
                val numbers = values[slot.name] ?: continue
                if (slot.kind != Kind.SAMPLER && numbers.size == slot.size) machine[slot] = numbers
            }
        }
    }

    /** Sets what the samplers have everywhere, red, green and blue; white for those that are not in [texels]. */
    fun setTextures(texels: Map<String, DoubleArray>) {
        for (machine in listOf(vertex, fragment)) {
            for (slot in machine.shader.uniforms.filter { it.kind == Kind.SAMPLER }) {
                val (r, g, b) = texels[slot.name] ?: WHITE
                machine[slot] = Sampler.constant(r, g, b, 1.0)
            }
        }
    }

    init {
        // A surface is seen from its front.
        pair.fragment.slot("gl_FrontFacing")?.let { fragment[it] = doubleArrayOf(1.0) }
    }

    /** What happens at a vertex; null where it comes to no colour. */
    fun at(attributes: Attributes): Trace? {
        if (!runVertex(attributes)) return null
        fragment.takeVaryings(vertex)
        if (fragment.run(fragmentTape) != Outcome.DONE) return null
        return Trace.of(pair, keys, vertexTape, fragmentTape)
    }

    /** The numbers of [at] alone, without how they were made; null where it comes to no colour. */
    fun rowAt(attributes: Attributes): Row? {
        if (!runVertex(attributes)) return null
        fragment.takeVaryings(vertex)
        return if (fragment.run(fragmentTape) == Outcome.DONE) Row.of(vertexTape, fragmentTape) else null
    }

    /** What happens inside of a triangle, at the weighted mean of its [corners]; null where it comes to no colour. */
    fun inside(corners: List<Attributes>, weights: DoubleArray): Trace? {
        val mixed = HashMap<String, DoubleArray>()
        for ((attributes, weight) in corners.zip(weights.toList())) {
            if (!runVertex(attributes)) return null
            for (slot in pair.vertex.outputs) {
                val numbers = vertex[slot]
                val sum = mixed.getOrPut(slot.name) { DoubleArray(numbers.size) }
                for (i in sum.indices) sum[i] += weight * numbers[i]
            }
        }
        for (slot in pair.fragment.inputs) mixed[slot.name]?.let { if (it.size == slot.size) fragment[slot] = it }
        if (fragment.run(fragmentTape) != Outcome.DONE) return null
        return Trace.of(pair, keys, null, fragmentTape)
    }

    /** What the vertex shader alone makes of a vertex; null where it does not end. */
    fun vertexAt(attributes: Attributes): Trace? = if (runVertex(attributes)) Trace.ofVertex(keys, vertexTape) else null

    private fun runVertex(attributes: Attributes): Boolean {
        for ((slot, location) in inputs) {
            val given = attributes[location] ?: NOTHING
            vertex[slot] = DoubleArray(slot.size) { given.getOrElse(it) { i -> NOTHING[i] } }
        }
        return vertex.run(vertexTape) == Outcome.DONE
    }

    private companion object {
        val WHITE = doubleArrayOf(1.0, 1.0, 1.0)
        val NOTHING = doubleArrayOf(0.0, 0.0, 0.0, 1.0)
    }
}
