package cga.imaging.report

import cga.imaging.Comparison
import cga.imaging.Picture
import cga.imaging.Severity

/**
 * One case of a report.
 *
 * @param name short and unique: `step-4.7-t5.3`.
 * @param messages why it ended as it did, a sentence each; the first is shown in the overview.
 * @param comparison null where there was nothing to compare (a missing golden, a render that failed).
 * @param facts what made the pictures, as name and value: renderer, size, t, step, …
 * @param picture the picture that there is nevertheless, where there is no comparison.
 */
public class ReportCase(
    public val name: String,
    public val severity: Severity,
    public val messages: List<String>,
    public val comparison: Comparison?,
    public val facts: List<Pair<String, String>> = emptyList(),
    public val picture: Picture? = null,
)
