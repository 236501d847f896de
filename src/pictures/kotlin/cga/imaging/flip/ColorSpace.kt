package cga.imaging.flip

import kotlin.math.max
import kotlin.math.min

/**
 * The colour spaces of ꟻLIP.
 *
 * *Opponent colours* are here y, x − y and y − z, where x, y, z are CIE XYZ relative to white. The papers' YCxCz is (116·y − 16,
 * 500·(x − y), 200·(y − z)); between two filters whose weights sum up to 1 those constants cancel.
 *
 * The matrices and the white point (D65) are those of the reference implementation, whose two directions are rounded to nine digits
 * each.
 */
internal object ColorSpace {
    private const val WHITE_X = 0.950428545f
    private const val WHITE_Z = 1.088900371f
    private const val PER_WHITE_X = 1.052156925f
    private const val PER_WHITE_Z = 0.918357670f

    private const val X_RED = PER_WHITE_X * 10135552f / 24577794f
    private const val X_GREEN = PER_WHITE_X * 8788810f / 24577794f
    private const val X_BLUE = PER_WHITE_X * 4435075f / 24577794f
    private const val Y_RED = 2613072f / 12288897f
    private const val Y_GREEN = 8788810f / 12288897f
    private const val Y_BLUE = 887015f / 12288897f
    private const val Z_RED = PER_WHITE_Z * 1425312f / 73733382f
    private const val Z_GREEN = PER_WHITE_Z * 8788810f / 73733382f
    private const val Z_BLUE = PER_WHITE_Z * 70074185f / 73733382f

    private const val RED_X = WHITE_X * 3.241003275f
    private const val RED_Y = -1.537398934f
    private const val RED_Z = WHITE_Z * -0.498615861f
    private const val GREEN_X = WHITE_X * -0.969224334f
    private const val GREEN_Y = 1.875930071f
    private const val GREEN_Z = WHITE_Z * 0.041554224f
    private const val BLUE_X = WHITE_X * 0.055639423f
    private const val BLUE_Y = -0.204011202f
    private const val BLUE_Z = WHITE_Z * 1.057148933f

    /** Turns [row] from linear RGB into opponent colours. */
    fun linearToOpponent(row: ColorRow) {
        val first = row.first
        val second = row.second
        val third = row.third
        for (i in first.indices) {
            val red = first[i]
            val green = second[i]
            val blue = third[i]
            val y = Y_RED * red + Y_GREEN * green + Y_BLUE * blue
            first[i] = y
            second[i] = X_RED * red + X_GREEN * green + X_BLUE * blue - y
            third[i] = y - (Z_RED * red + Z_GREEN * green + Z_BLUE * blue)
        }
    }

    /** Turns [row] from opponent colours into CIELab whose a and b are scaled with L/100 (Hunt: darker colours look greyer). */
    fun opponentToHuntLab(row: ColorRow) {
        val first = row.first
        val second = row.second
        val third = row.third
        for (i in first.indices) {
            val y = first[i]
            val x = y + second[i]
            val z = y - third[i]
            val red = clamped(RED_X * x + RED_Y * y + RED_Z * z)
            val green = clamped(GREEN_X * x + GREEN_Y * y + GREEN_Z * z)
            val blue = clamped(BLUE_X * x + BLUE_Y * y + BLUE_Z * z)
            val lightX = lightness(X_RED * red + X_GREEN * green + X_BLUE * blue)
            val lightY = lightness(Y_RED * red + Y_GREEN * green + Y_BLUE * blue)
            val lightZ = lightness(Z_RED * red + Z_GREEN * green + Z_BLUE * blue)
            val l = 116f * lightY - 16f
            first[i] = l
            second[i] = 0.01f * l * 500f * (lightX - lightY)
            third[i] = 0.01f * l * 200f * (lightY - lightZ)
        }
    }

    private fun clamped(value: Float): Float = max(0f, min(value, 1f))

    /** CIELab's f(t): a cube root that ends in a straight line near 0. */
    private fun lightness(t: Float): Float = if (t > 0.008856452f) cubeRoot(t) else 7.787037f * t + 0.13793103f

    /** The cube root of a normal, positive number, within 3e-7 of its value: a guess from the exponent and two steps of Halley's method. */
    internal fun cubeRoot(value: Float): Float {
        val guess = Float.fromBits(value.toRawBits() / 3 + 0x2a51_4067)
        val better = halley(guess, value)
        return halley(better, value)
    }

    private fun halley(
        root: Float,
        value: Float,
    ): Float {
        val cube = root * root * root
        return root * (cube + 2 * value) / (2 * cube + value)
    }
}
