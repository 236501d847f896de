package cga.grading.reading

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.UniformValue
import cga.reader.shader.Source
import org.joml.Matrix4d
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4
import kotlin.math.abs
import kotlin.random.Random

/** What a program computes: the picture as a sum of terms, and what each factor of them is. */
internal class ProgramReading private constructor(
    val probe: Probe,
    val spaceFinder: SpaceFinder,
    val spaces: Spaces,
    val samples: Samples,
    val finder: VectorFinder,
    val factors: FactorFinder,
    val vectors: List<KnownVector>,
    val terms: List<Term>,
    val encoding: Encoding,
    val normal: Int?,
    val position: Int,
    private val uniforms: Map<String, DoubleArray>,
) {
    /** Branches that let lights shine in cones only. */
    val gates: Gates = Gates(samples, spaces, FactorFinder.constants(vectors))

    /** What happens inside of a triangle, under the uniforms that the program was read with. */
    fun inside(corners: List<SamplePoint>, weights: DoubleArray): Trace? {
        probe.set(uniforms)
        return probe.inside(corners.map { it.attributes }, weights)
    }

    companion object {
        private const val SEED = 1
        private const val POINTS = 40
        private const val REACH = 2.0
        private val FLOATS = setOf(GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC4)

        /** Reads program [number] of [capture] as the draws of [frames] use it; null where no picture comes of it. Throws [Unreadable]. */
        fun of(capture: Capture, number: Int, frames: List<List<CapturedDraw>>): ProgramReading? {
            val program = capture.programs[number]
            val pair = ShaderPair.of(program)
            if (pair.color == null) return null
            val probe = Probe(pair, program)
            val random = Random(SEED)
            val draw = representative(frames.flatten()) ?: return null
            probe.setTextures(emptyMap())
            val position = position(probe, draw) ?: return null
            val spaceFinder = SpaceFinder(probe, position)
            spaceFinder.learn(frames, draw)
            val spaces = spaceFinder.of(values(draw)) ?: return null
            val uniforms = values(draw) + randomized(draw, spaces, random)
            probe.set(uniforms)
            val texels = probe.samplers.associateWith {
                doubleArrayOf(random.nextDouble(0.2, 0.9), random.nextDouble(0.2, 0.9), random.nextDouble(0.2, 0.9))
            }
            probe.setTextures(texels)
            val points = List(POINTS) { SamplePoint.random(random, probe.attributes, position, REACH) }
            val first = Samples.of(probe, points)
            if (first.size < POINTS / 2) return null
            val normal = normal(first, probe, position)
            val vectorFinder = VectorFinder(first, normal)
            val vectors = vectorFinder.find()
            val sweeps = Sweeps(probe, spaces, first.points[0])
            val samples = first.with(
                Samples.of(probe, sweeps.points(FactorFinder.places(vectors, spaces), FactorFinder.constants(vectors), first, random)),
            )
            val factors = FactorFinder(samples, vectorFinder, vectors, spaces, sweeps)
            val encoded = Encoding.of(samples)
            val terms = TermFinder(samples, factors).of(encoded.sums)
            return ProgramReading(
                probe, spaceFinder, spaces, samples, vectorFinder, factors, vectors, terms, encoded.encoding, normal, position, uniforms,
            )
        }

        fun values(draw: CapturedDraw): Map<String, DoubleArray> =
            draw.uniforms.associate { uniform -> uniform.name to DoubleArray(uniform.numbers.size) { uniform.numbers[it].toDouble() } }

        /** The draw whose matrices differ most from none: there no two spaces are alike. Later ones first, by then all is set. */
        private fun representative(draws: List<CapturedDraw>): CapturedDraw? =
            draws.asReversed().take(200).maxByOrNull { draw -> draw.uniforms.filter { it.numbers.size == 16 }.sumOf(::difference) }

        private fun difference(uniform: UniformValue): Double =
            uniform.numbers.indices.sumOf { abs(uniform.numbers[it] - if (it % 5 == 0) 1f else 0f).toDouble().coerceAtMost(1.0) }

        /** The attribute that gl_Position is made of. */
        private fun position(probe: Probe, draw: CapturedDraw): Int? {
            probe.set(values(draw))
            val trace = probe.vertexAt(probe.attributes.keys.associateWith { doubleArrayOf(0.3, 0.4, 0.5, 1.0) }) ?: return null
            return inputs(trace.position.orEmpty()).mapNotNull { probe.location(it) }.maxByOrNull { probe.attributes.getValue(it) }
        }

        /** Of the attributes of three numbers beside the position the one that the colour is made of. */
        private fun normal(samples: Samples, probe: Probe, position: Int): Int? {
            val names = samples.traces.flatMap { inputs(it.color) }.distinct()
            return names.mapNotNull { probe.location(it) }.find { it != position && probe.attributes.getValue(it) >= 3 }
        }

        /**
         * Numbers that no two uniforms share, in the place of the vectors that [draw] sent: what a shader computes shows by them, whatever was sent. The
         * camera's place stays.
         */
        private fun randomized(draw: CapturedDraw, spaces: Spaces, random: Random): Map<String, DoubleArray> {
            val eye = spaces.view?.invert(Matrix4d())?.transformPosition(Vector3d())
            return draw.uniforms
                .filter {
                    if (it.type ==
                        GL_FLOAT_VEC3
                    ) {
                        eye == null || !isNear(it.numbers, eye)
                    } else {
                        it.type in FLOATS && isZero(it)
                    }
                }.associate { uniform -> uniform.name to DoubleArray(uniform.numbers.size) { random.nextDouble(0.3, 1.5) } }
        }

        /** Whether nothing was sent, as it seems. */
        private fun isZero(uniform: UniformValue) = uniform.numbers.all { it == 0f }

        private fun isNear(numbers: FloatArray, point: Vector3d) =
            point.distance(numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()) < 1e-3 * (1 + point.length())

        private fun inputs(nodes: List<Node>): List<String> {
            val seen = HashSet<Node>()
            val found = LinkedHashSet<String>()
            val open = ArrayDeque(nodes)
            while (open.isNotEmpty()) {
                val node = open.removeLast()
                if (!seen.add(node)) continue
                (node.source as? Source.Input)?.let { found += it.slot.name }
                open += node.operands
            }
            return found.toList()
        }
    }
}
