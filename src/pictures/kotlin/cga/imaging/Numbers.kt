package cga.imaging

import java.math.BigDecimal
import java.math.MathContext
import java.util.Locale
import kotlin.math.abs

// How numbers are written: the same wherever the program runs.

/** [number] with a comma every three digits. */
internal fun grouped(number: Int): String = "%,d".format(Locale.ROOT, number)

/** [value] to four digits that say something. */
public fun brief(value: Double): String {
    val size = abs(value)
    return when {
        value == 0.0 -> "0"
        !value.isFinite() -> "$value"
        size >= 1e4 || size < 1e-3 -> "%.2e".format(Locale.ROOT, value)
        else -> BigDecimal(value).round(MathContext(4)).stripTrailingZeros().toPlainString()
    }
}

/** [share] of 1 in per cent; never 0 or 100 where it is not. */
public fun percent(share: Double): String =
    when {
        share > 0 && share < 1e-4 -> "< 0.01 %"
        share < 1 && share > 0.9999 -> "> 99.99 %"
        else -> "%.2f".format(Locale.ROOT, 100 * share).trimEnd('0').trimEnd('.') + " %"
    }

/** A difference of pictures of the kind of [picture]: in steps of a byte where it has bytes. */
public fun step(value: Double, picture: Picture): String {
    if (value == 0.0 || picture is FloatPicture) return brief(value)
    // A whole number of steps, divided by 255 and multiplied again, may be a rounding away from it; brief forgets that.
    return brief(value * BYTE) + "/255"
}

/** The compared channels of [picture] at [at], in its own numbers: bytes, or floats however large. */
public fun values(picture: Picture, at: Pixel): List<Float> {
    val first = 4 * (at.y * picture.width + at.x)
    return (first until first + channels(picture)).map {
        when (picture) {
            is BytePicture -> (picture.image.rgba[it].toInt() and 0xFF).toFloat()
            is FloatPicture -> picture.image.rgba[it]
        }
    }
}

internal fun channels(picture: Picture): Int = if (picture.hasAlpha) 4 else 3

internal val CHANNEL_NAMES: List<String> = listOf("red", "green", "blue", "alpha")

/** [values] of one pixel in a row, each with as many digits as tell it from every other float. */
public fun written(values: List<Float>): String = values.joinToString("  ") { "$it".removeSuffix(".0") }

/** By how much [found] is more than [wanted], number by number. */
internal fun change(wanted: List<Float>, found: List<Float>): String =
    wanted.zip(found) { a, b -> b.toDouble() - a.toDouble() }.joinToString("  ") { (if (it > 0) "+" else "") + brief(it) }

private const val BYTE = 255
