package cga.inspect.doctor

import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.model.MeshData
import org.joml.Intersectiond
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc

/** What lies around a point of a frame's world: found by rays against its triangles. */
internal class Surroundings(frame: Frame) {
    private val bodies = frame.draws.map(::Body)

    /** Whether [point] (world space) is below a surface that is seen from above, with nothing further down: under or in the ground. */
    fun isUnderGround(point: Vector3dc): Boolean {
        val above = nearest(point, UP)
        val below = nearest(point, DOWN)
        val isTouching = minOf(above?.distance ?: Double.MAX_VALUE, below?.distance ?: Double.MAX_VALUE) < TOUCHING
        return isTouching || (above != null && !above.isFront && below == null)
    }

    /** Whether most of what is seen from [point] (world space) is seen from behind. */
    fun isInside(point: Vector3dc): Boolean {
        val hits = DIRECTIONS.mapNotNull { nearest(point, it) }
        return hits.count { !it.isFront } > hits.size / 2
    }

    private class Hit(
        val distance: Double,
        val isFront: Boolean,
    )

    private fun nearest(
        point: Vector3dc,
        direction: Vector3dc,
    ): Hit? = bodies.mapNotNull { it.hit(point, direction) }.minByOrNull { it.distance }

    /** The triangles of one draw, in world space. */
    private class Body(draw: FrameDraw) {
        private val corners: List<Vector3d>
        private val mirrors = Matrix4d(draw.model).determinant3x3() < 0

        init {
            val floats = draw.vertices
            val places =
                (floats.indices step MeshData.FLOATS_PER_VERTEX).map { at ->
                    draw.model.transformPosition(Vector3d(floats[at].toDouble(), floats[at + 1].toDouble(), floats[at + 2].toDouble()))
                }
            corners = draw.indices.map(places::get)
        }

        fun hit(
            point: Vector3dc,
            direction: Vector3dc,
        ): Hit? {
            var best = Double.MAX_VALUE
            var first = -1
            for (i in corners.indices step 3) {
                val t = Intersectiond.intersectRayTriangle(point, direction, corners[i], corners[i + 1], corners[i + 2], 0.0)
                if (t >= 0 && t < best) {
                    best = t
                    first = i
                }
            }
            if (first < 0) return null
            val a = corners[first]
            val normal = Vector3d(corners[first + 1]).sub(a).cross(Vector3d(corners[first + 2]).sub(a))
            return Hit(best, (normal.dot(direction) < 0) != mirrors)
        }
    }

    private companion object {
        /** So near that the light grazes the surface and lights nothing of it. */
        const val TOUCHING = 1e-3
        val UP: Vector3dc = Vector3d(0.0, 1.0, 0.0)
        val DOWN: Vector3dc = Vector3d(0.0, -1.0, 0.0)

        /** To the faces and the corners of a cube; not along the axes exactly, where rays meet edges. */
        val DIRECTIONS: List<Vector3dc> =
            listOf(-1, 0, 1)
                .flatMap { x -> listOf(-1, 0, 1).flatMap { y -> listOf(-1, 0, 1).map { z -> Triple(x, y, z) } } }
                .filter { (x, y, z) -> x * x + y * y + z * z in setOf(1, 3) }
                .map { (x, y, z) -> Vector3d(x + 0.013, y + 0.017, z + 0.019).normalize() }
    }
}
