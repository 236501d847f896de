package cga.reference

import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.model.MeshData
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector4d

/**
 * The vertices of one draw after the vertex shader, in double precision.
 *
 * Where they are in the window is kept in homogeneous coordinates, (x·w, y·w, z·w, w) for the window coordinates (x, y, z): pixels
 * from the lower left corner of the picture, depth from 0 to 1. The division by w, which a vertex behind the eye would not survive, is
 * left to [Projected].
 */
public class Vertices(
    frame: Frame,
    public val draw: FrameDraw,
    width: Int,
    height: Int,
) {
    private val count = draw.vertices.size / MeshData.FLOATS_PER_VERTEX

    /** Four numbers a vertex. */
    public val window: DoubleArray = DoubleArray(4 * count)

    /** In view space; three numbers a vertex. */
    public val position: DoubleArray = DoubleArray(3 * count)

    /** In view space, any length; three numbers a vertex. */
    public val normal: DoubleArray = DoubleArray(3 * count)

    /** Multiplied; two numbers a vertex. */
    public val texCoord: DoubleArray = DoubleArray(2 * count)

    init {
        val modelView = frame.view.mul(draw.model, Matrix4d())
        val normalMatrix = normalMatrix(modelView)
        val toWindow = windowMatrix(width, height).mul(Matrix4d(frame.projection))
        val multiplier = draw.material.tcMultiplier
        val p = Vector3d()
        val n = Vector3d()
        val clip = Vector4d()
        for (vertex in 0 until count) {
            val at = vertex * MeshData.FLOATS_PER_VERTEX
            val floats = draw.vertices
            modelView.transformPosition(floats[at].toDouble(), floats[at + 1].toDouble(), floats[at + 2].toDouble(), p)
            toWindow.transform(p.x, p.y, p.z, 1.0, clip)
            normalMatrix.transform(n.set(floats[at + 5].toDouble(), floats[at + 6].toDouble(), floats[at + 7].toDouble()))
            texCoord[2 * vertex] = floats[at + 3].toDouble() * multiplier.x()
            texCoord[2 * vertex + 1] = floats[at + 4].toDouble() * multiplier.y()
            for (i in 0..2) position[3 * vertex + i] = p[i]
            for (i in 0..2) normal[3 * vertex + i] = n[i]
            for (i in 0..3) window[4 * vertex + i] = clip[i]
        }
    }

    private companion object {
        /** Clip space → window, still homogeneous (OpenGL 3.3 core, section 2.14.1): −1…1 becomes 0…width, 0…height and 0…1. */
        fun windowMatrix(
            width: Int,
            height: Int,
        ): Matrix4d = Matrix4d().translation(width / 2.0, height / 2.0, 0.5).scale(width / 2.0, height / 2.0, 0.5)

        /**
         * Keeps normals perpendicular to their surface: det(M)·(M⁻¹)ᵀ up to a positive factor, which is the cofactor matrix, turned
         * around where M mirrors, so that the inverse is never needed.
         */
        fun normalMatrix(modelView: Matrix4dc): Matrix3d {
            val m = modelView.get3x3(Matrix3d())
            return m.cofactor(Matrix3d()).scale(if (m.determinant() < 0) -1.0 else 1.0)
        }
    }
}
