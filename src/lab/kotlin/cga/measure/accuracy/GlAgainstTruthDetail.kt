package cga.measure.accuracy

import org.joml.Vector2d
import org.joml.Vector2dc
import kotlin.math.abs
import kotlin.math.log2
import kotlin.math.max
import kotlin.math.min

/**
 * Which λ OpenGL allows at a pixel.
 *
 * For ρ any function between max(m_u, m_v) and m_u + m_v may be taken (3.3 core, section 3.8.11, after equation 3.22), m_u being the larger
 * of |∂u/∂x| and |∂u/∂y|; and derivatives may be differences between neighbours, whichever (GLSL 3.30, section 8.7). So all differences
 * within the 3×3 pixels around are looked at, and the exact derivatives.
 *
 * @param place texture coordinates at a point of the window, null where there are none.
 */
internal class GlAgainstTruthDetail(
    x: Double,
    y: Double,
    exact: List<Vector2dc>,
    place: (Double, Double) -> Vector2d?,
) {
    private val stencil = List(3) { j -> List(3) { i -> place(x + i - 1, y + j - 1) } }
    private val dx = differences(exact[0]) { j, i -> difference(stencil[j][i], stencil[j][i + 1]) }
    private val dy = differences(exact[1]) { j, i -> difference(stencil[i][j], stencil[i + 1][j]) }

    /** What may be taken for λ where a texture has [width] by [height] texels and coordinates err by [errors] between neighbours. */
    fun allowed(
        width: Int,
        height: Int,
        errors: Vector2dc,
    ): ClosedFloatingPointRange<Double> {
        if (dx == null || dy == null) return 0.0..Double.MAX_VALUE
        val u = extent(dx, dy, width, errors.x()) { it.x() }
        val v = extent(dx, dy, height, errors.y()) { it.y() }
        return log2(max(u.start, v.start)) - LOG_ERROR..log2(u.endInclusive + v.endInclusive)
    }

    /** By how much derivatives change from a pixel to the next, in texture coordinates. */
    fun bend(): Vector2d {
        if (dx == null || dy == null) return Vector2d(Double.POSITIVE_INFINITY)

        fun of(component: (Vector2dc) -> Double) = listOf(dx, dy).maxOf { list -> list.maxOf(component) - list.minOf(component) }
        return Vector2d(of { it.x() }, of { it.y() })
    }

    /** m_u, from the least to the most; with [Vector2dc.y], m_v. */
    private fun extent(
        dx: List<Vector2dc>,
        dy: List<Vector2dc>,
        size: Int,
        error: Double,
        component: (Vector2dc) -> Double,
    ): ClosedFloatingPointRange<Double> {
        val least = max(dx.minOf { abs(component(it)) }, dy.minOf { abs(component(it)) }) - error
        val most = max(dx.maxOf { abs(component(it)) }, dy.maxOf { abs(component(it)) }) + error
        return max(least, 0.0) * size..most * size
    }

    private fun differences(
        exact: Vector2dc,
        of: (Int, Int) -> Vector2dc?,
    ): List<Vector2dc>? {
        val all = (0..2).flatMap { j -> (0..1).map { i -> of(j, i) } }.filterNotNull()
        return if (all.size == 6) all + exact else null
    }

    private fun difference(
        from: Vector2d?,
        to: Vector2d?,
    ): Vector2dc? = if (from == null || to == null) null else to.sub(from, Vector2d())

    companion object {
        /**
         * OpenGL gives no precision for λ's logarithm. llvmpipe's is linear between powers of 2, up to 0.0861 below the true one, halved
         * since it is taken of ρ².
         */
        const val LOG_ERROR = 0.0431

        /** λ ± what the relative error of ρ makes of it. */
        fun around(
            lambda: Double,
            relative: Double,
        ): ClosedFloatingPointRange<Double> = lambda + log2(max(1 - relative, 0.0))..lambda + log2(1 + min(relative, Double.MAX_VALUE))
    }
}
