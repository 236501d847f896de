package cga.imaging.flip

import cga.framework.image.FloatImage
import kotlin.math.max
import kotlin.math.min
import kotlin.math.pow

/** A linear picture of floats, exposed by [stop] f-stops and tone mapped with [AcesCurve]. */
internal class ExposedRows(
    private val image: FloatImage,
    stop: Float,
) : LinearRows {
    override val width: Int get() = image.width
    override val height: Int get() = image.height

    private val factor = 2f.pow(stop)

    override fun read(
        y: Int,
        row: ColorRow,
    ) {
        val rgba = image.rgba
        var at = 4 * y * width
        for (x in 0 until width) {
            row.first[x] = AcesCurve.map(rgba[at] * factor)
            row.second[x] = AcesCurve.map(rgba[at + 1] * factor)
            row.third[x] = AcesCurve.map(rgba[at + 2] * factor)
            at += 4
        }
    }
}

/**
 * The ACES tone mapper as fitted by Krzysztof Narkowicz (*ACES Filmic Tone Mapping Curve*, 2016), with his pre-exposure of 0.6 inside:
 * (a·x² + b·x) / (c·x² + d·x + e).
 */
internal object AcesCurve {
    private const val A = 0.6f * 0.6f * 2.51f
    private const val B = 0.6f * 0.03f
    private const val C = 0.6f * 0.6f * 2.43f
    private const val D = 0.6f * 0.59f
    private const val E = 0.14f

    /** Far beyond white, and its square is still a float. */
    private const val LIMIT = 1e18f

    /** A linear [value] on a screen, 0..1. Negative values are mapped by the same formula, as the reference implementation does. */
    fun map(value: Float): Float {
        val x = max(-LIMIT, min(value, LIMIT))
        return max(0f, min((A * x * x + B * x) / (C * x * x + D * x + E), 1f))
    }

    /** The value that is mapped to [target]: the larger root of the quadratic equation. */
    fun inverse(target: Float): Float {
        val a = A - target * C
        val half = -0.5f * ((B - target * D) / a)
        return half + kotlin.math.sqrt(half * half + target * E / a)
    }
}
