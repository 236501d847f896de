package cga.testing

import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.pow
import kotlin.math.sin

/** A complex number x + i·z: a point of the ground plane, and as a factor a turn of it. */
class Complex(val re: Double, val im: Double) {
    operator fun minus(other: Complex) = Complex(re - other.re, im - other.im)

    operator fun times(other: Complex) = Complex(re * other.re - im * other.im, re * other.im + im * other.re)

    operator fun div(other: Complex): Complex {
        val square = other.re * other.re + other.im * other.im
        return Complex((re * other.re + im * other.im) / square, (im * other.re - re * other.im) / square)
    }

    /** In polar form, which is one rounding and not [n]. */
    fun power(n: Int): Complex {
        val length = hypot(re, im).pow(n)
        val angle = atan2(im, re) * n
        return Complex(length * cos(angle), length * sin(angle))
    }
}
