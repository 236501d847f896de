package cga.imaging

import cga.imaging.flip.Flip
import cga.imaging.flip.FlipMap

/** Two pictures and all that can be said of their difference; what costs time is computed when it is asked for, once. */
public class Comparison(
    public val expected: Picture,
    public val actual: Picture,
) {
    /** Number by number. Making a [Comparison] throws [cga.framework.InputError] where the pictures cannot be compared. */
    public val difference: Difference = Difference.between(expected, actual)

    /** Whether every compared number is the same. */
    public val isIdentical: Boolean get() = difference.differing == 0

    /** As an eye would see it. */
    public val flip: FlipMap by lazy { Flip.compare(expected, actual) }

    private val windows = HashMap<Int, Window>()

    /** The worst window of [size]×[size] pixels. */
    public fun worstWindow(size: Int): Window = windows.getOrPut(size) { Window.worst(expected, actual, size) }

    public companion object {
        /** The side of the worst window that is reported, in pixels. */
        public const val WINDOW: Int = 16
    }
}
