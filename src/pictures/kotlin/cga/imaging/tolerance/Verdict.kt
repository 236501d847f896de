package cga.imaging.tolerance

import cga.imaging.Severity

/**
 * What a [Tolerance] says of two pictures.
 *
 * @param messages a sentence for each bound that was passed: metric, value, bound, where, and why the bound is what it is. None for a pass.
 */
public class Verdict(
    public val severity: Severity,
    public val messages: List<String>,
) {
    internal companion object {
        val PASS = Verdict(Severity.PASS, emptyList())
    }
}
