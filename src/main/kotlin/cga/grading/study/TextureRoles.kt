package cga.grading.study

import org.joml.Vector3d
import kotlin.math.max
import kotlin.random.Random

/**
 * What each sampler is for, by the name of its uniform; null for a role that none has.
 *
 * @param multiplied whether light only shows where the emission texture is not black.
 * @param untextured whether a light shows with all textures black, relative to how it shows with white ones.
 */
internal class TextureRoles(
    val emission: String?,
    val diffuse: String?,
    val specular: String?,
    val multiplied: Boolean,
    val untextured: Double,
) {
    /** Texture colours that leave only the diffuse term. */
    val onlyDiffuse: Map<String, Double> = listOfNotNull(diffuse, emission.takeIf { multiplied }).associateWith { 1.0 }

    /** Texture colours that leave only the specular term. */
    val onlySpecular: Map<String, Double> = listOfNotNull(specular, emission.takeIf { multiplied }).associateWith { 1.0 }

    companion object {
        /** Finds the roles from one light, which shines on [points]. */
        fun of(
            probe: LightProbe,
            points: List<Vector3d>,
            flats: List<ActiveUniform>,
        ): TextureRoles {
            val samplers = probe.box.program.samplers.map { it.name }
            val all = samplers.associateWith { 1.0 }
            val samples = samples(points)
            val full = probe.shade(samples, all).largest()
            val needed = samplers.filter { probe.shade(samples, all - it).largest() < DEAD * full && samplers.size > 1 }
            val multiplier = needed.singleOrNull { it !in samplers.filter { t -> probe.shade(samples, mapOf(t to 1.0)).largest() > TINY } }
            val always = listOfNotNull(multiplier).associateWith { 1.0 }
            val linearity =
                (samplers - always.keys)
                    .associateWith { nonlinearity(probe, points, always + (it to 1.0)) }
                    .filterValues { it != null }
                    .mapValues { it.value ?: 0.0 }
            val diffuse = linearity.filterValues { it < HALF }.minByOrNull { it.value }?.key
            val specular = (linearity.keys - setOfNotNull(diffuse)).maxByOrNull { linearity.getValue(it) }
            val glowing = glowing(probe.box, samples, samplers, flats)
            val emission = multiplier ?: glowing.firstOrNull { it != diffuse && it != specular }
            return TextureRoles(emission, diffuse, specular, multiplier != null, probe.shade(samples, emptyMap()).largest() / full)
        }

        /** Samplers that show without any light. */
        private fun glowing(
            box: BlackBox,
            samples: List<Sample>,
            samplers: List<String>,
            flats: List<ActiveUniform>,
        ): List<String> {
            val dark = Setting().withColors(flats, 1.0)
            val black = box.shade(samples, dark)
            return samplers.filter { name ->
                val white = box.shade(samples, dark.withTexels(mapOf(name to 1.0)))
                // Lights shine on all that a light's texture colours; emission is the same for every normal.
                val effect = DoubleArray(white.size) { white[it] - black[it] }
                effect.largest() > DEAD && white.isNotEmpty()
            }
        }

        /** 0 where the light that [texels] leave is a clamped cosine of the normal, near 1 where it is nothing like it; null where there is none. */
        fun nonlinearity(
            probe: LightProbe,
            points: List<Vector3d>,
            texels: Map<String, Double>,
        ): Double? {
            val random = Random(3)
            val gradients = probe.gradients(points, texels)
            val samples = points.flatMap { p -> List(NORMALS) { Sample(p, Directions.random(random)) } }
            val shades = probe.shade(samples, texels)
            if (max(shades.largest(), gradients.maxOf { it.strength }) < TINY) return null
            var difference = 0.0
            var sum = 0.0
            for (i in samples.indices) {
                val g = gradients[i / NORMALS]
                val value = shades[i] - g.floor
                val expected = max(g.direction.dot(samples[i].normal), 0.0)
                if (!value.isFinite()) continue
                difference += kotlin.math.abs(value - expected)
                sum += kotlin.math.abs(value) + expected
            }
            return if (sum > 0) difference / sum else 1.0
        }

        private fun samples(points: List<Vector3d>): List<Sample> {
            val random = Random(2)
            return points.flatMap { p -> List(NORMALS) { Sample(p, Directions.random(random)) } + Directions.AXES.map { Sample(p, it) } }
        }

        private const val NORMALS = 10
        private const val HALF = 0.35
        private const val DEAD = 1e-5

        // With all other textures black nothing is rounded against anything: what is not 0 is there.
        private const val TINY = 1e-9
    }
}
