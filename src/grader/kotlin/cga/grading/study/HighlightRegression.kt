package cga.grading.study

import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.max
import kotlin.math.pow

/** One hypothesis about the specular term, fitted in logarithms: the exponent is common, every point has a strength of its own. */
internal class HighlightRegression(
    private val spaces: Spaces,
    private val placement: Placement,
    private val lobe: Lobe,
    private val eye: EyeVector,
    private val reversed: Boolean,
) {
    fun fit(
        samples: List<Sample>,
        values: DoubleArray,
    ): HighlightFit? {
        samplesSeen = samples
        val cosines = DoubleArray(samples.size) { cosine(samples[it]) ?: return null }
        val brightest = values.largest()
        var xx = 0.0
        var xy = 0.0
        val groups = samples.indices.chunked(HighlightFit.PER_POINT)
        val used = groups.map { group -> group.filter { values[it] > VISIBLE * brightest && cosines[it] > 1e-3 } }
        for (group in used) {
            if (group.size < 3) continue
            val meanX = group.sumOf { ln(cosines[it]) } / group.size
            val meanY = group.sumOf { ln(values[it]) } / group.size
            for (i in group) {
                xx += (ln(cosines[i]) - meanX) * (ln(cosines[i]) - meanX)
                xy += (ln(cosines[i]) - meanX) * (ln(values[i]) - meanY)
            }
        }
        if (!(xx > 0)) return null
        val exponent = xy / xx
        return judge(groups, used, cosines, values, exponent)
    }

    private fun judge(
        groups: List<List<Int>>,
        used: List<List<Int>>,
        cosines: DoubleArray,
        values: DoubleArray,
        exponent: Double,
    ): HighlightFit {
        var difference = 0.0
        var sum = 0.0
        var negative = 0.0
        var positive = 0.0
        for ((group, bright) in groups.zip(used)) {
            val strength = if (bright.isEmpty()) {
                0.0
            } else {
                Math.exp(bright.sumOf { ln(values[it]) - exponent * ln(cosines[it]) } / bright.size)
            }
            for (i in group) {
                if (!values[i].isFinite()) continue
                val power = strength * abs(cosines[i]).pow(exponent)
                sum += abs(values[i])
                if (cosines[i] > 0) {
                    // A highlight may be gated by n·l: nothing where the light is behind the surface is no difference.
                    if (values[i] != 0.0 || !isBehind(i)) difference += abs(values[i] - power)
                    positive += power
                } else {
                    negative += abs(values[i])
                    if (values[i] != 0.0) difference += abs(abs(values[i]) - power)
                }
            }
        }
        return HighlightFit(lobe, eye, reversed, exponent, difference / max(sum, 1e-300), negative > 1e-3 * max(positive, 1e-300))
    }

    private var samplesSeen: List<Sample> = emptyList()

    private fun isBehind(i: Int): Boolean {
        val sample = samplesSeen[i]
        return placement.normalOf(sample.normal).dot(placement.toLight(sample.position)) <= 0
    }

    private fun cosine(sample: Sample): Double? {
        val v = HighlightFit.toEye(eye, spaces, placement, sample.position) ?: return null
        val l = placement.toLight(sample.position)
        return HighlightFit.cosine(lobe, placement.normalOf(sample.normal).normalize(), if (reversed) l.negate() else l, v)
    }

    private companion object {
        const val VISIBLE = 1e-5
    }
}
