package cga.reference

/**
 * One triangle as the eye sees it, and the place in it that a point of the window shows: after Olano and Greer, *Triangle Scan
 * Conversion using 2D Homogeneous Coordinates* (1997).
 *
 * With corners p_i = (x_i·w_i, y_i·w_i, w_i), the window point q = (X, Y, 1) is seen where q is a positive combination of the corners.
 * The weights are the edge functions
 *
 *     e_0 = det(q, p_1, p_2),  e_1 = det(p_0, q, p_2),  e_2 = det(p_0, p_1, q),
 *
 * each 0 on one edge and positive on the triangle's side of it. Nothing is divided by w, so a triangle that reaches behind the eye
 * needs no clipping: what is seen of it lies where all three are positive. And b_i = e_i / (e_0 + e_1 + e_2) are the weights
 * of the corners *in space*: the perspective-correct interpolation of OpenGL's equation 3.9, f = Σ b_i·f_i.
 *
 * Filled again for every triangle and every point; [look] and then [at] come before all else.
 */
public class Projected {
    // The corners; x and y are still multiplied by w.
    private var x0 = 0.0
    private var y0 = 0.0
    private var z0 = 0.0
    private var w0 = 0.0
    private var x1 = 0.0
    private var y1 = 0.0
    private var z1 = 0.0
    private var w1 = 0.0
    private var x2 = 0.0
    private var y2 = 0.0
    private var z2 = 0.0
    private var w2 = 0.0

    // How the edge functions change with X and Y.
    private var e0dx = 0.0
    private var e0dy = 0.0
    private var e1dx = 0.0
    private var e1dy = 0.0
    private var e2dx = 0.0
    private var e2dy = 0.0

    /** The edge functions at the point. */
    public var e0: Double = 0.0
        private set
    public var e1: Double = 0.0
        private set
    public var e2: Double = 0.0
        private set

    /** Takes triangle [number]. */
    public fun look(
        triangles: Triangles,
        number: Int,
    ) {
        val window = triangles.vertices(number).window
        val i0 = 4 * triangles.corner(number, 0)
        val i1 = 4 * triangles.corner(number, 1)
        val i2 = 4 * triangles.corner(number, 2)
        x0 = window[i0]
        y0 = window[i0 + 1]
        z0 = window[i0 + 2]
        w0 = window[i0 + 3]
        x1 = window[i1]
        y1 = window[i1 + 1]
        z1 = window[i1 + 2]
        w1 = window[i1 + 3]
        x2 = window[i2]
        y2 = window[i2 + 1]
        z2 = window[i2 + 2]
        w2 = window[i2 + 3]
        e0dx = y1 * w2 - w1 * y2
        e0dy = w1 * x2 - x1 * w2
        e1dx = y2 * w0 - w2 * y0
        e1dy = w2 * x0 - x2 * w0
        e2dx = y0 * w1 - w0 * y1
        e2dy = w0 * x1 - x0 * w1
    }

    /**
     * Whether the corners go round counter-clockwise as seen, which is OpenGL's front. det(p_0, p_1, p_2) is twice the area in the window
     * times the three w, so its sign is that of the visible part also where some w is negative.
     */
    public val isFront: Boolean get() = x0 * e0dx + y0 * e0dy + w0 * (x1 * y2 - y1 * x2) > 0

    /** The part of the window that the triangle lies in: all of it where a corner is behind the eye. */
    public val left: Double get() = if (isInFront) minOf(x0 / w0, x1 / w1, x2 / w2) else Double.NEGATIVE_INFINITY
    public val right: Double get() = if (isInFront) maxOf(x0 / w0, x1 / w1, x2 / w2) else Double.POSITIVE_INFINITY
    public val bottom: Double get() = if (isInFront) minOf(y0 / w0, y1 / w1, y2 / w2) else Double.NEGATIVE_INFINITY
    public val top: Double get() = if (isInFront) maxOf(y0 / w0, y1 / w1, y2 / w2) else Double.POSITIVE_INFINITY

    private val isInFront get() = w0 > 0 && w1 > 0 && w2 > 0

    /** Whether any point of the rectangle may be covered: an edge function is largest in the corner that it grows towards. */
    public fun mayCover(
        left: Int,
        bottom: Int,
        width: Int,
        height: Int,
    ): Boolean {
        fun look(
            dx: Double,
            dy: Double,
        ) = at(if (dx > 0) left + width.toDouble() else left.toDouble(), if (dy > 0) bottom + height.toDouble() else bottom.toDouble())
        look(e0dx, e0dy)
        if (e0 < 0) return false
        look(e1dx, e1dy)
        if (e1 < 0) return false
        look(e2dx, e2dy)
        return e2 >= 0
    }

    /**
     * Takes the window point ([x], [y]).
     *
     * The corners are moved so that the point is the origin: det(q, p_1, p_2) is then a product of two vectors in the plane, small where
     * it should be, with no large numbers to cancel. And of two triangles that share an edge, the one computes exactly the negative of
     * the other.
     */
    public fun at(
        x: Double,
        y: Double,
    ) {
        val ax = x0 - x * w0
        val ay = y0 - y * w0
        val bx = x1 - x * w1
        val by = y1 - y * w1
        val cx = x2 - x * w2
        val cy = y2 - y * w2
        e0 = bx * cy - by * cx
        e1 = cx * ay - cy * ax
        e2 = ax * by - ay * bx
    }

    /**
     * Whether the triangle is seen at the point: it is within all three edges and between the near and the far plane. A point on an edge
     * belongs to the triangle on its right; on a horizontal edge, to the one below: of two triangles that share the edge, to exactly one.
     */
    public val covers: Boolean
        get() = isInside(e0, e0dx, e0dy) && isInside(e1, e1dx, e1dy) && isInside(e2, e2dx, e2dy) && depth in 0.0..1.0

    private fun isInside(
        e: Double,
        dx: Double,
        dy: Double,
    ) = e > 0 || (e == 0.0 && (dx > 0 || (dx == 0.0 && dy < 0)))

    /** Window depth at the point, linear in the window (OpenGL's equation 3.10). */
    public val depth: Double get() = (e0 * z0 + e1 * z1 + e2 * z2) / (e0 * w0 + e1 * w1 + e2 * w2)

    /** The corners' weights at the point; their sum is 1. */
    public val b0: Double get() = e0 / (e0 + e1 + e2)
    public val b1: Double get() = e1 / (e0 + e1 + e2)
    public val b2: Double get() = e2 / (e0 + e1 + e2)

    /** How the weights change with X: the derivative of the quotient. */
    public val b0dx: Double get() = (e0dx - b0 * (e0dx + e1dx + e2dx)) / (e0 + e1 + e2)
    public val b1dx: Double get() = (e1dx - b1 * (e0dx + e1dx + e2dx)) / (e0 + e1 + e2)
    public val b2dx: Double get() = (e2dx - b2 * (e0dx + e1dx + e2dx)) / (e0 + e1 + e2)

    /** The same with Y. */
    public val b0dy: Double get() = (e0dy - b0 * (e0dy + e1dy + e2dy)) / (e0 + e1 + e2)
    public val b1dy: Double get() = (e1dy - b1 * (e0dy + e1dy + e2dy)) / (e0 + e1 + e2)
    public val b2dy: Double get() = (e2dy - b2 * (e0dy + e1dy + e2dy)) / (e0 + e1 + e2)
}
