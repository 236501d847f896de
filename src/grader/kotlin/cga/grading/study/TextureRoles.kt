package cga.grading.study

import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.max
import kotlin.random.Random

/**
 * What each sampler is for, by the name of its uniform; null for a role that none has.
 *
 * @param multiplied whether light only shows where the emission texture is not black.
 * @param inLights whether the emission texture only shows by lights, beside the other textures and whatever the normal.
 * @param peak the term that lights are measured by.
 * @param powers what the colours of the diffuse and of the specular texture are raised to, by sampler, as far as known.
 * @param untextured whether a light shows with all textures black, relative to how it shows with white ones.
 */
internal class TextureRoles(
    val emission: String?,
    val diffuse: String?,
    val specular: String?,
    val multiplied: Boolean,
    val untextured: Double,
    val peak: Peak = Peak.DIFFUSE,
    val powers: Map<String, Double> = emptyMap(),
    val inLights: Boolean = false,
) {
    /** Texture colours that leave only the diffuse term. */
    val onlyDiffuse: Map<String, Double> = listOfNotNull(diffuse, emission.takeIf { multiplied }).associateWith { 1.0 }

    /** Texture colours that leave only the specular term. */
    val onlySpecular: Map<String, Double> = listOfNotNull(specular, emission.takeIf { multiplied }).associateWith { 1.0 }

    /** Whether diffuse and specular term have one texture. */
    val isShared: Boolean get() = diffuse != null && diffuse == specular

    /** These with the other's work for the diffuse and the specular texture: the exponent is at the cosine of the diffuse term. */
    fun exchanged(): TextureRoles = TextureRoles(emission, specular, diffuse, multiplied, untextured, Peak.POWER, powers, inLights)

    /** These with the diffuse texture for the specular term as well. */
    fun shared(): TextureRoles = TextureRoles(emission, diffuse, diffuse, multiplied, untextured, peak, powers, inLights)

    companion object {
        /** Finds the roles from one light, which shines on [points]. */
        fun of(
            probe: LightProbe,
            points: List<Vector3d>,
            colors: ColorSlots,
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
            val clamped = linearity.filterValues { it < HALF }.minByOrNull { it.value }?.key
            val diffuse = clamped ?: linearity.keys.firstOrNull { isTwoSided(probe, points, always + (it to 1.0)) }
            val peak = if (clamped != null) {
                Peak.DIFFUSE
            } else if (diffuse != null) {
                Peak.TWO_SIDED
            } else {
                Peak.SPECULAR
            }
            val others = linearity.keys - setOfNotNull(diffuse)
            val glowing = glowing(probe.box, samples, samplers, colors)
            val lit = others.singleOrNull { isEven(probe, points, it) }?.takeIf { multiplier == null && glowing.none(others::contains) }
            val specular = (others - setOfNotNull(lit)).maxByOrNull { linearity.getValue(it) }
            val emission = multiplier ?: lit ?: glowing.firstOrNull { it != diffuse && it != specular }
            val powers =
                listOfNotNull(diffuse, specular).mapNotNull { name -> exponent(probe, samples, always, name)?.let { name to it } }.toMap()
            return TextureRoles(
                emission, diffuse, specular, multiplier != null,
                probe
                    .shade(
                        samples,
                        emptyMap(),
                    ).largest() / full,
                peak, powers, lit != null,
            )
        }

        /** Samplers that show without any light. */
        private fun glowing(
            box: BlackBox,
            samples: List<Sample>,
            samplers: List<String>,
            colors: ColorSlots,
        ): List<String> {
            val dark = Setting().withColors(colors.lights, 0.0).withColors(colors.flats + colors.factors, 1.0)
            val black = box.shade(samples, dark)
            return samplers.filter { name ->
                val white = box.shade(samples, dark.withTexels(mapOf(name to 1.0)))
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
                difference += abs(value - expected)
                sum += abs(value) + expected
            }
            return if (sum > 0) difference / sum else 1.0
        }

        /** Whether the light that shows by the texture [name] alone is the same for all normals. */
        private fun isEven(
            probe: LightProbe,
            points: List<Vector3d>,
            name: String,
        ): Boolean = points.all { point ->
            val shades = probe.shade(samples(listOf(point)), mapOf(name to 1.0))
            // A highlight may be met by none of the normals.
            shades.largest() > TINY && shades.max() - shades.min() <= EVEN * shades.largest()
        }

        /** The power of the texture [name] that light is multiplied by; null where the texture does more than that. */
        private fun exponent(
            probe: LightProbe,
            samples: List<Sample>,
            always: Map<String, Double>,
            name: String,
        ): Double? {
            val levels = listOf(1.0, 0.5, 0.25).map { probe.shade(samples, always + (name to it)).largest() }
            val (first, second) = levels.zipWithNext { more, less -> ln(more / less) / ln(2.0) }
            return first.takeIf { abs(first - second) < 0.05 }
        }

        /** Whether opposite normals receive the same light, and not only few of them: the cosine without its sign. */
        private fun isTwoSided(
            probe: LightProbe,
            points: List<Vector3d>,
            texels: Map<String, Double>,
        ): Boolean {
            val random = Random(14)
            val samples = points.flatMap { p ->
                List(NORMALS) { Directions.random(random) }.flatMap { listOf(Sample(p, it), Sample(p, Vector3d(it).negate())) }
            }
            val shades = probe.shade(samples, texels)
            if (!(shades.largest() > TINY)) return false
            return points.indices.all { i ->
                val here = DoubleArray(2 * NORMALS) { shades[2 * NORMALS * i + it] }
                val isEven = (0 until NORMALS).all { abs(here[2 * it] - here[2 * it + 1]) <= EVEN * here.largest() }
                isEven && here.average() > BROAD * here.max()
            }
        }

        private fun samples(points: List<Vector3d>): List<Sample> {
            val random = Random(2)
            return points.flatMap { p -> List(NORMALS) { Sample(p, Directions.random(random)) } + Directions.AXES.map { Sample(p, it) } }
        }

        private const val NORMALS = 10
        private const val HALF = 0.35
        private const val EVEN = 1e-3

        // The mean of |cos| over all directions is a half of its largest, of |cos|^k it is 1/(k + 1).
        private const val BROAD = 0.3
        private const val DEAD = 1e-5

        // With all other textures black nothing is rounded against anything: what is not 0 is there.
        private const val TINY = 1e-9
    }
}
