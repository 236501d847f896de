package cga.measure.accuracy.hard

import cga.reference.LightContribution
import org.joml.Vector3d
import kotlin.math.sin

/**
 * How far the shader's floats may be from the formula, for one light on one point whose position is exact in view space.
 *
 * With u = 2⁻²⁴ and the precisions of GLSL (4.60, section 4.7.1: inversesqrt 2 ulp, division 2.5 ulp, logarithm 2⁻²¹ near 1 and 3 ulp
 * elsewhere, exp2 (3 + 2|x|) ulp; an ulp is 2u), to first order: light − position errs by u of each component; normalising adds 3u/2 from
 * the squared length, 4u, and a product, 7u; a cosine of two such vectors errs by twice 8u and 3u for the sum of products.
 */
internal object Rounding {
    /** Unit roundoff of a float. */
    const val U: Double = 1.0 / (1 shl 24)

    /** Of n·l. */
    const val COSINE: Double = 19 * U

    /** Of F, as a share of it: twice the distance's u, 3u for the squares, 3 terms and sums, a division. */
    const val ATTENUATION: Double = 13 * U

    /** Two products and a sum on the way to the pixel, as a share. */
    const val PRODUCTS: Double = 6 * U

    /**
     * Of I. The rounding of inversesqrt and of the squared length only change how long l is, and |l − s|² = |l|² + |s|² − 2·l·s is at its
     * smallest there: such an error ε counts as ε². What moves the chord, of length c ≤ 2·sin(outer/2) where it matters, is the rounding of
     * components: u in light − position, u in l, u in s, each a vector of length u at most. So c²/2 errs by 3u·c, by 3u of itself for the
     * three squares and sums, by (3u + 7u)²/2, and each of the versines by u of itself.
     */
    fun cone(
        inner: Double,
        outer: Double,
    ): Double {
        val chord = 2 * sin(outer / 2)
        val versine = chord * chord / 2
        val width = versine - 2 * sin(inner / 2) * sin(inner / 2)
        return (3 * U * chord + 5 * U * versine + 50 * U * U) / width + 5 * U
    }

    /**
     * Of max(cos β, 0)^k, which is at most 1. The power multiplies the cosine's error by k, and the logarithm's.
     *
     * @param cosine the error of cos β: [phongCosine] or [halfCosine].
     */
    fun highlight(
        cosine: Double,
        k: Double,
    ): Double = k * (cosine + 6 * U) + 9 * U

    /** Of r·v: r = l − 2·(n·l)·n errs by 8u + 2·19u + 2·7u + 3u = 63u, and its product with v by another 7u + 3u. */
    const val PHONG_COSINE: Double = 73 * U

    /** Of n·h: the sum of two vectors with 8u and 7u errs by 15u + u·|h|, divided by its length; then as for n·l. */
    fun halfCosine(sumLength: Double): Double = 15 * U / sumLength + 19 * U

    /** |l + v| of unit vectors. */
    fun sumLength(
        share: LightContribution,
        toCamera: Vector3d,
    ): Double = share.toLight.add(toCamera, Vector3d()).length()
}
