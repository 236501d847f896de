package cga.grading.study

import java.util.Locale
import kotlin.math.abs

/** A cone whose axis was sent with another length than 1 and never normalised: the cosine to it is that many times too large. */
internal object AxisLength {
    /** The length of [lengths] that makes the edges of [cone] those that were sent, among [numbers]; null where none does. */
    fun of(
        cone: ConeFit,
        numbers: Collection<Double>,
        lengths: Collection<Double>,
    ): Double? =
        when (cone.falloff) {
            Falloff.LINEAR -> lengths.firstOrNull { ConeWords.of(cone.cosInner * it, cone.cosOuter * it, numbers) != null }
            // So short that no angle is within the inner cone: its edge is not to be seen.
            Falloff.UNCLAMPED_ABOVE ->
                if (isSent(cone.cosOuter, numbers)) null else lengths.firstOrNull { it < 1 && isSent(cone.cosOuter * it, numbers) }
            else -> null
        }

    /** What is wrong where the axis is [length] long. */
    fun text(length: Double): String = "the axis is ${"%.3f".format(Locale.ROOT, length)} long and not normalised"

    private fun isSent(
        cosine: Double,
        numbers: Collection<Double>,
    ) = AngleForm.entries.any { form -> numbers.any { abs(form.cosine(it) - cosine) < NEAR } }

    // As for two edges in ConeWords.
    private const val NEAR = 2e-5
}
