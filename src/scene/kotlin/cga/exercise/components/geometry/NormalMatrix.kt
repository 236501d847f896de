package cga.exercise.components.geometry

import org.joml.Matrix3d
import org.joml.Matrix3f
import org.joml.Matrix4dc
import kotlin.math.abs
import kotlin.math.sign

/**
 * The matrix that keeps normals perpendicular to their surface, whatever a model matrix does to it.
 *
 * The textbook's transposed inverse is the cofactor matrix divided by the determinant, and shading normalises the result anyway: only
 * the determinant's sign matters (it keeps the normals of a mirrored model pointing outwards). So nothing is divided, and a matrix that
 * flattens the model is no special case. Scaling by the largest element first and last keeps the products within range
 * (Lengyel, *Foundations of Game Engine Development 1*, 2016, section 1.7 and 3.2 for cofactors and normals).
 */
public class NormalMatrix {
    private val scratch = Matrix3d()

    /** Fills [dest] with the normal matrix of [modelView], up to a positive factor; the largest element is 1, or all are 0. */
    public fun of(
        modelView: Matrix4dc,
        dest: Matrix3f,
    ): Matrix3f {
        modelView.get3x3(scratch)
        scratch.scaleToUnit()
        val orientation = sign(scratch.determinant())
        scratch.cofactor()
        scratch.scaleToUnit()
        if (orientation < 0.0) scratch.multiply(-1.0)
        for (column in 0..2) for (row in 0..2) dest[column, row] = scratch[column, row].toFloat()
        return dest
    }

    private fun Matrix3d.scaleToUnit() {
        var largest = 0.0
        for (column in 0..2) for (row in 0..2) largest = maxOf(largest, abs(this[column, row]))
        if (largest > 0.0) multiply(1.0 / largest)
    }

    private fun Matrix3d.multiply(factor: Double) {
        set(m00 * factor, m01 * factor, m02 * factor, m10 * factor, m11 * factor, m12 * factor, m20 * factor, m21 * factor, m22 * factor)
    }
}
