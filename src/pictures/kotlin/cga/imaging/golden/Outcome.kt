package cga.imaging.golden

import cga.imaging.Comparison
import cga.imaging.Severity

/**
 * How the picture of a case stands to what was approved.
 *
 * @param messages why, a sentence each, the most important first.
 * @param comparison with the approved image that it is most like; null where there was none.
 * @param isSkipped whether nothing was judged, because no tolerance is for this renderer.
 */
public class Outcome(
    public val severity: Severity,
    public val messages: List<String>,
    public val comparison: Comparison? = null,
    public val isSkipped: Boolean = false,
)
