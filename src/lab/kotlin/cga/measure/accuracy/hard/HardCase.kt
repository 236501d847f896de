package cga.measure.accuracy.hard

/**
 * One case in which the obvious arithmetic goes wrong, measured.
 *
 * @param name what is computed, and where.
 * @param naive the obvious form, in floats; [naiveError] its largest error, NaN where it has no number to show (NaN or infinity).
 * @param ours what this program does instead; [ourError] its largest error, [bound] what it may be at most, by derivation.
 * @param failure where and why the naive form fails; empty where it serves.
 */
public data class HardCase(
    public val name: String,
    public val naive: String,
    public val naiveError: Double,
    public val ours: String,
    public val ourError: Double,
    public val bound: Double,
    public val unit: ErrorUnit,
    public val failure: String,
) {
    /** Whether the naive form is so far off that it shows, or has no number at all. */
    public val naiveFails: Boolean get() = !(naiveError <= unit.visible)
}

/**
 * What errors are counted in.
 *
 * @param visible an error beyond this one shows in a picture.
 */
public enum class ErrorUnit(
    public val label: String,
    internal val visible: Double,
) {
    /** Steps of an 8-bit colour. */
    COLOR("1/255", 1.0),

    /** Units in the last place of a float, of the largest number of the vector: 2¹⁵ ulp are 1/256 of it. */
    ULP("ulp", 32_768.0),

    /** Parts of the size of what is shown. */
    SHARE("of the size", 1.0 / 256),

    /** World units, where one is about the length of the motorcycle. */
    WORLD("units", 0.01),
}
