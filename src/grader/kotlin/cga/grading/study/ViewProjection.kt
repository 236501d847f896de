package cga.grading.study

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector4d
import kotlin.math.abs

/**
 * The product of a projection and a view matrix, split.
 *
 * A symmetric perspective along −z maps (x, y, z, 1) to (a·x, b·y, c·z + d, −z). So the last row of the product is that of the view's z,
 * reversed; the first two are multiples of its x and y; and what is left of the third is d.
 *
 * @param view a rotation, a translation and an even scale.
 */
internal class ViewProjection private constructor(
    val projection: Matrix4dc,
    val view: Matrix4dc,
) {
    companion object {
        /** Splits [product]; null where it is no such product. */
        fun of(product: Matrix4dc): ViewProjection? {
            val (x, y, z, w) = List(4) { product.getRow(it, Vector4d()) }
            val back = Vector4d(w).negate()
            val scale = back.xyz().length()
            if (!(scale > 0)) return null
            val a = x.xyz().length() / scale
            val b = y.xyz().length() / scale
            val c = z.xyz().dot(back.xyz()) / (scale * scale)
            val d = z.w - c * back.w
            if (!(a > 0 && b > 0) || z.xyz().distance(back.xyz().mul(c)) > EXACT * scale * abs(c)) return null
            val view = Matrix4d().setRow(0, x.div(a)).setRow(1, y.div(b)).setRow(2, back)
            if (!view.isEven()) return null
            val projection = Matrix4d().zero().m00(a).m11(b).m22(c).m32(d).m23(-1.0)
            return ViewProjection(projection, view)
        }

        private fun Vector4d.xyz() = Vector3d(x, y, z)

        /** Relative; the product is one of floats. */
        private const val EXACT = 1e-4
    }
}
