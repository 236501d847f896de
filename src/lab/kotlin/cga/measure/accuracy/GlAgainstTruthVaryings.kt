package cga.measure.accuracy

import cga.framework.Frame
import cga.framework.model.MeshData
import cga.reference.Triangles
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector2d
import org.joml.Vector3dc
import kotlin.math.abs

/**
 * What the fragment shader is handed at a pixel of one triangle, with bounds.
 *
 * OpenGL says how to interpolate (equation 3.9 of 3.3 core: f = P/Q, where P = f/w and Q = 1/w are linear in the window) and not how
 * accurately. What is assumed here:
 *
 * - each corner is moved by at most half a step of the sub-pixel grid in x and in y, rounding of its window coordinates included; inside
 *   of the triangle that moves every point by no more, and f by at most its slope times that;
 * - a driver holds P and Q as c + X·∂x + Y·∂y from the window's corner on and spends [PLANE_ULPS] roundings on them, each an ulp of the
 *   largest of the three; far from that corner, steep planes of small triangles feel it;
 * - w of each corner is off by [W_ULPS], which moves f by that share of the difference between the corners.
 *
 * @param grid steps of the sub-pixel grid in a pixel.
 */
internal class GlAgainstTruthVaryings(
    private val frame: Frame,
    triangles: Triangles,
    number: Int,
    grid: Int,
) {
    private val draw = frame.draws[triangles.draw(number)]
    private val vertices = triangles.vertices(number)
    private val corners = IntArray(3) { triangles.corner(number, it) }
    private val window = corners.map { corner -> DoubleArray(4) { vertices.window[4 * corner + it] } }
    private val step = 0.5 / grid
    private val q = plane(doubleArrayOf(1.0, 1.0, 1.0))

    private val positionErrors = positionErrors()
    private val normalErrors = normalErrors()
    private val position = List(3) { i -> Varying(values(vertices.position, 3, i), positionErrors[i]) }
    private val normal = List(3) { i -> Varying(values(vertices.normal, 3, i), normalErrors[i]) }
    private val texCoord = List(2) { i -> values(vertices.texCoord, 2, i).let { Varying(it, Bounded.ULP * largest(it)) } }
    private val lights =
        frame.lights.map {
            val place = frame.view.transformPosition(it.position, org.joml.Vector3d())
            List(3) { i -> toLight(place, i) }
        }

    /** −1 in the direction of the eye: toCameraView is its negative. */
    fun position(
        x: Double,
        y: Double,
    ): BoundedVector = vector(position, x, y)

    fun normal(
        x: Double,
        y: Double,
    ): BoundedVector = vector(normal, x, y)

    /** From the surface to light number [light] of the frame. */
    fun toLight(
        light: Int,
        x: Double,
        y: Double,
    ): BoundedVector = vector(lights[light], x, y)

    /** Texture coordinate s (0) or t (1). */
    fun texCoord(
        i: Int,
        x: Double,
        y: Double,
    ): Bounded = texCoord[i].at(x, y)

    /** How much of [texCoord]'s error is rounding, which differs from pixel to pixel; the rest moves neighbours alike. */
    fun texCoordRounding(
        i: Int,
        x: Double,
        y: Double,
    ): Double = texCoord[i].rounding(x, y)

    /** The texture coordinates on the plane of the triangle, also outside of it; null behind the eye. */
    fun texCoordOrNull(
        x: Double,
        y: Double,
    ): Vector2d? = if (q.at(x, y) > 0) Vector2d(texCoord[0].value(x, y), texCoord[1].value(x, y)) else null

    private fun vector(
        of: List<Varying>,
        x: Double,
        y: Double,
    ) = BoundedVector(of[0].at(x, y), of[1].at(x, y), of[2].at(x, y))

    private fun toLight(
        place: Vector3dc,
        i: Int,
    ): Varying {
        val values = DoubleArray(3) { place[i] - position[i].values[it] }
        return Varying(values, positionErrors[i] + Bounded.ULP * (abs(place[i]) + largest(values)))
    }

    /** modelView·position: entries rounded to floats, products, three sums. */
    private fun positionErrors(): DoubleArray {
        val m = frame.view.mul(draw.model, Matrix4d())
        return DoubleArray(3) { row ->
            val size = corners.maxOf { abs(m[3, row]) + (0..2).sumOf { i -> abs(m[i, row] * attribute(it, i)) } }
            5 * Bounded.ULP * size
        }
    }

    /** normalMatrix·normal: entries rounded to floats, products, two sums. In the units of the reference's normals. */
    private fun normalErrors(): DoubleArray {
        val m = frame.view.mul(draw.model, Matrix4d()).get3x3(Matrix3d())
        m.cofactor()
        return DoubleArray(3) { row ->
            val size = corners.maxOf { (0..2).sumOf { i -> abs(m[i, row] * attribute(it, NORMAL + i)) } }
            4 * Bounded.ULP * size
        }
    }

    private fun attribute(
        vertex: Int,
        i: Int,
    ) = draw.vertices[vertex * MeshData.FLOATS_PER_VERTEX + i].toDouble()

    private fun values(
        data: DoubleArray,
        components: Int,
        i: Int,
    ) = DoubleArray(3) { data[components * corners[it] + i] }

    private fun largest(values: DoubleArray) = values.maxOf { abs(it) }

    /** The plane of f/w for the numbers [f] at the corners, up to the same factor as all others: see the reference's edge functions. */
    private fun plane(f: DoubleArray): Plane {
        var origin = 0.0
        var dx = 0.0
        var dy = 0.0
        for (i in 0..2) {
            val (bx, by, _, bw) = window[(i + 1) % 3]
            val (cx, cy, _, cw) = window[(i + 2) % 3]
            dx += f[i] * (by * cw - bw * cy)
            dy += f[i] * (bw * cx - bx * cw)
            origin += f[i] * (bx * cy - by * cx)
        }
        return Plane(origin, dx, dy)
    }

    private class Plane(
        val origin: Double,
        val dx: Double,
        val dy: Double,
    ) {
        fun at(
            x: Double,
            y: Double,
        ) = origin + x * dx + y * dy

        /** What a rounding in the sum is proportional to. */
        fun size(
            x: Double,
            y: Double,
        ) = abs(origin) + abs(x * dx) + abs(y * dy)
    }

    /** @param cornerError how far off the number is at each corner. */
    private inner class Varying(
        val values: DoubleArray,
        private val cornerError: Double,
    ) {
        private val p = plane(values)
        private val spread = values.max() - values.min()

        fun value(
            x: Double,
            y: Double,
        ) = p.at(x, y) / q.at(x, y)

        fun at(
            x: Double,
            y: Double,
        ): Bounded {
            val value = value(x, y)
            val moved = step * (abs(p.dx - value * q.dx) + abs(p.dy - value * q.dy)) / leastQ(x, y)
            return Bounded(value, moved + rounding(x, y))
        }

        fun rounding(
            x: Double,
            y: Double,
        ): Double {
            val value = abs(value(x, y))
            val planes = PLANE_ULPS * (p.size(x, y) + value * q.size(x, y)) / leastQ(x, y)
            // The last term: the quotient itself, or a reciprocal and a product.
            return cornerError + Bounded.ULP * (planes + W_ULPS * spread + 3.5 * value)
        }

        private fun leastQ(
            x: Double,
            y: Double,
        ): Double {
            val least = q.at(x, y) - step * (abs(q.dx) + abs(q.dy)) - PLANE_ULPS * Bounded.ULP * q.size(x, y)
            return if (least > 0) least else Double.MIN_VALUE
        }
    }

    private companion object {
        /** Four for c, four for the sum. */
        const val PLANE_ULPS = 8.0

        /** 1/w is used twice; w is a sum of products, and its reciprocal one more. */
        const val W_ULPS = 16.0

        /** Where a vertex's normal starts. */
        const val NORMAL = 5
    }
}
