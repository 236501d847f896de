package cga.grading.reading

import java.util.BitSet

/** What a term has of a texture: the sampler and what its colours are raised to. */
internal data class Texel(val sampler: String, val power: Double)

/**
 * A summand of the picture.
 *
 * @property textures what it is multiplied with, of textures; [colors] of colours that are not of a texture: for red, green and blue one node each.
 * @property factors what all three channels have in common.
 * @property sign how often it is there, negative where it is taken away.
 * @property runs the samples in which it was added at all: a branch may leave it out.
 */
internal class Term(
    val textures: List<Texel>,
    val colors: List<List<Node>>,
    val factors: List<Factor>,
    val sign: Double,
    val runs: BitSet,
) {
    /** The points that its factors speak of. */
    val ways: List<ToPoint> = factors.mapNotNull {
        when (it) {
            is Factor.Cosine -> it.light.way
            is Factor.Highlight -> it.light.way
            is Factor.Fade -> it.way
            is Factor.Cone -> it.way
            else -> null
        }
    }
}
