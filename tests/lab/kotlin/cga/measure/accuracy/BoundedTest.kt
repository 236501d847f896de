package cga.measure.accuracy

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt
import kotlin.random.Random

/** The arithmetic of bounds against floats: Java's are correctly rounded, which is one way of doing what GLSL asks. */
class BoundedTest {
    private val random = Random(1)

    @Test
    fun `a cosine in floats is within its bound`() =
        repeat(10_000) {
            val (a, b) = vector() to vector()
            val cosine = dot(normalize(a), normalize(b))
            assertWithin(a.bounded().normalize().dot(b.bounded().normalize()), cosine)
        }

    @Test
    fun `a highlight in floats is within its bound`() =
        repeat(10_000) {
            val cosine = random.nextFloat()
            val k = random.nextFloat() * 1000
            val exact = Bounded(cosine.toDouble()).pow(k.toDouble())
            // exp2(k·log2(x)) with each step rounded to a float; the last digits of the logarithm are what k multiplies.
            val exponent = (k * kotlin.math.log2(cosine.toDouble()).toFloat())
            assertWithin(exact, 2.0.pow(exponent.toDouble()).toFloat())
        }

    @Test
    fun `a quotient of differences in floats is within its bound`() =
        repeat(10_000) {
            val (a, b, c) = List(3) { random.nextFloat() }
            if (abs(b - c) < 1e-3f) return@repeat
            assertWithin((bounded(a) - bounded(c)) / (bounded(b) - bounded(c)), (a - c) / (b - c))
        }

    @Test
    fun `an error of a cosine is multiplied by k and the power`() {
        val error = Bounded(0.9, 1e-6).pow(60.0).error - Bounded(0.9).pow(60.0).error
        assertEquals(60 * 0.9.pow(59) * 1e-6, error, 1e-3 * error)
    }

    @Test
    fun `the bound of a power grows with k`() {
        // At the edge of a highlight, where x^k is a half.
        val bounds = listOf(8.0, 60.0, 1000.0).map { k -> Bounded(0.5.pow(1 / k)).pow(k).error }
        assertTrue(bounds[0] < bounds[1] && bounds[1] < bounds[2]) { "$bounds" }
        // GLSL's 2⁻²¹ for the logarithm, times k·ln 2, of the half.
        assertEquals(1000 * kotlin.math.ln(2.0) * 0.5 / (1 shl 21), bounds[2], 0.1 * bounds[2])
    }

    @Test
    fun `the bound of a vector's direction grows as it cancels`() {
        fun directionError(
            length: Double,
        ) = BoundedVector(Bounded(length, 1e-7), Bounded(0.0, 1e-7), Bounded(0.0, 1e-7)).normalize().y.error
        assertEquals(1000.0, directionError(1e-3) / directionError(1.0), 10.0)
    }

    @Test
    fun `nothing is said of a division by what may be 0`() {
        assertEquals(Double.POSITIVE_INFINITY, (Bounded(1.0) / Bounded(1e-8, 1e-7)).error)
        assertEquals(Double.POSITIVE_INFINITY, Bounded(1e-8, 1e-7).inverseSqrt().error)
    }

    private fun assertWithin(
        bound: Bounded,
        float: Float,
    ) = assertTrue(abs(bound.value - float) <= bound.error) {
        "$float is ${abs(bound.value - float)} from ${bound.value}, allowed ${bound.error}"
    }

    private fun vector() = List(3) { random.nextFloat() - 0.5f }

    private fun List<Float>.bounded() = BoundedVector(bounded(this[0]), bounded(this[1]), bounded(this[2]))

    private fun bounded(x: Float) = Bounded(x.toDouble())

    private fun dot(
        a: List<Float>,
        b: List<Float>,
    ) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    private fun normalize(a: List<Float>): List<Float> = a.map { it * (1f / sqrt(dot(a, a))) }
}
