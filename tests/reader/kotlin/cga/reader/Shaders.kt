package cga.reader

import cga.reader.run.Machine
import cga.reader.run.Sampler
import cga.reader.shader.Kind
import cga.reader.shader.Shader
import cga.reader.shader.Slot
import cga.reader.shader.Stage
import kotlin.random.Random

/** The shader of [text], or the failure of the test. */
internal fun shader(text: String, stage: Stage = Stage.FRAGMENT, file: String = "x"): Shader =
    when (val reading = Reading.of(file, text, stage)) {
        is Reading.Done -> reading.shader
        is Reading.Failed -> throw AssertionError(reading.problems.joinToString("\n"))
    }

/** A fragment shader whose main is [body], line 10 of it. */
internal fun fragment(body: String, declarations: String = ""): Shader =
    shader("#version 330 core\nout vec4 color;\n${declarations.trim()}\n#line 10\nvoid main() { $body }\n")

/** The color that [body] gives where inputs and uniforms are as [given]. */
internal fun color(body: String, declarations: String = "", given: Map<String, DoubleArray> = emptyMap()): List<Double> {
    val machine = Machine(fragment(body, declarations))
    for ((name, numbers) in given) machine[name] = numbers
    machine.run()
    return machine["color"].asList()
}

/** Numbers for a slot, each a float, so that OpenGL can have the same. */
internal fun Random.numbersFor(slot: Slot): DoubleArray =
    DoubleArray(slot.size) { i ->
        when (slot.kind) {
            Kind.BOOL -> nextInt(2).toDouble()
            Kind.INT, Kind.UINT -> nextInt(3).toDouble()
            Kind.SAMPLER -> error("${slot.name} has no numbers")
            // Like a matrix of a scene rather than any numbers: not far from the identity, so that it can be inverted.
            Kind.FLOAT ->
                if (slot.columns > 1) {
                    (if (i / slot.rows == i % slot.rows) 1.0 else 0.0) + float(-0.4, 0.4)
                } else if (slot.rows > 1) {
                    // More light than darkness, or hardly a highlight is seen.
                    float(-0.7, 2.0)
                } else {
                    float(0.1, 3.0)
                }
        }.toFloat().toDouble()
    }

internal fun Random.float(from: Double, to: Double): Double = nextDouble(from, to).toFloat().toDouble()

/** A texture of one colour. */
internal class OneColor(val rgba: DoubleArray) : Sampler by Sampler.constant(rgba[0], rgba[1], rgba[2], rgba[3])
