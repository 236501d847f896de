package cga.coach.ui

import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode

/** Numbers with as many digits as they need, four that count at most. A number that has been written is not written again. */
internal class Digits {
    private val written = HashMap<Float, String>()

    fun of(number: Float): String {
        written[number]?.let { return it }
        if (written.size > MOST) written.clear()
        return write(number).also { written[number] = it }
    }

    private fun write(number: Float): String {
        if (!number.isFinite()) return "$number"
        // A Float's own text is the shortest that is read back as the same.
        val rounded = BigDecimal("$number").round(MathContext(COUNTING, RoundingMode.HALF_EVEN))
        if (rounded.signum() == 0) return "0"
        val plain = rounded.stripTrailingZeros()
        return if (plain.precision() - plain.scale() in
            SMALL..LARGE
        ) {
            plain.toPlainString()
        } else {
            "%.3g".format(java.util.Locale.ROOT, number)
        }
    }

    private companion object {
        const val COUNTING = 4
        const val MOST = 2000

        /** Places of the first digit that counts, before the point, that are written without an exponent. */
        const val SMALL = -4
        const val LARGE = 7
    }
}
