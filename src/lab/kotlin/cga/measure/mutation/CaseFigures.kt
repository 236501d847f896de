package cga.measure.mutation

import cga.imaging.Comparison
import cga.imaging.Picture
import cga.imaging.Severity
import cga.imaging.tolerance.Tolerance
import cga.measure.golden.GoldenCase

/**
 * How far a changed picture of one case is from the one it should be.
 *
 * @param visiblePixels how many pixels differed by 1/255 or more before rounding.
 * @param maximum largest difference in a channel, in 1/255 (of a float picture too).
 * @param differing share of pixels that differ, 0..1.
 * @param window mean difference in the worst window of [Comparison.WINDOW] pixels a side, in 1/255.
 * @param flipMean mean ꟻLIP error.
 * @param verdict of the tolerant tier.
 */
public class CaseFigures private constructor(
    public val case: GoldenCase,
    public val visiblePixels: Int,
    public val isIdentical: Boolean,
    public val maximum: Double,
    public val differing: Double,
    public val window: Double,
    public val flipMean: Double,
    public val verdict: Severity,
) {
    /** Whether a defect is large enough to speak of, whatever a compare says. */
    public val isVisible: Boolean get() = visiblePixels >= VISIBLE_PIXELS

    public companion object {
        private const val VISIBLE_PIXELS = 16

        internal fun of(
            case: GoldenCase,
            expected: Picture,
            actual: Picture,
            tolerance: Tolerance,
            visiblePixels: Int = 0,
        ): CaseFigures {
            val comparison = Comparison(expected, actual)
            val identical = comparison.isIdentical
            return CaseFigures(
                case,
                visiblePixels,
                identical,
                255 * comparison.difference.maximum.max(),
                comparison.difference.fraction,
                if (identical) 0.0 else 255 * comparison.worstWindow(Comparison.WINDOW).error,
                if (identical) 0.0 else comparison.flip.mean,
                tolerance.judge(comparison).severity,
            )
        }
    }
}
