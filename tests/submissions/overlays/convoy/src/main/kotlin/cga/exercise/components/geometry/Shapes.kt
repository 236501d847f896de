package cga.exercise.components.geometry

import org.joml.Vector3f

/** Small things that need no model file. */
object Shapes {
    private val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    /** A box that stands on the origin. */
    fun box(width: Float, height: Float, depth: Float, material: Material): Mesh {
        val vertices = ArrayList<Float>()
        val indices = ArrayList<Int>()
        val normals = listOf(
            Vector3f(1f, 0f, 0f), Vector3f(-1f, 0f, 0f), Vector3f(0f, 1f, 0f),
            Vector3f(0f, -1f, 0f), Vector3f(0f, 0f, 1f), Vector3f(0f, 0f, -1f)
        )
        for (n in normals) {
            val u = if (n.y != 0f) Vector3f(1f, 0f, 0f) else Vector3f(0f, 1f, 0f)
            val v = Vector3f(n).cross(u)
            val first = vertices.size / 8
            for ((a, b) in listOf(-1f to -1f, 1f to -1f, 1f to 1f, -1f to 1f)) {
                val p = Vector3f(n).add(Vector3f(u).mul(a)).add(Vector3f(v).mul(b)).mul(0.5f)
                vertices += listOf(p.x * width, (p.y + 0.5f) * height, p.z * depth, 0.5f + a / 2, 0.5f + b / 2, n.x, n.y, n.z)
            }
            indices += listOf(first, first + 1, first + 2, first, first + 2, first + 3)
        }
        return Mesh(vertices.toFloatArray(), indices.toIntArray(), layout, material)
    }

    /** A flat square from 0 to 1, for the head-up display. */
    fun square(): Mesh = Mesh(
        floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f),
        intArrayOf(0, 1, 2, 0, 2, 3),
        arrayOf(VertexAttribute(3, 12, 0))
    )
}
