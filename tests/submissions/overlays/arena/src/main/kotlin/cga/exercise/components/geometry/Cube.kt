package cga.exercise.components.geometry

import org.joml.Vector3f

/** Würfel von -1 bis 1, mit eigenen Normalen und Texturkoordinaten für jede Seite. */
object Cube {
    val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    fun create(material: Material?): Mesh {
        val vertices = ArrayList<Float>()
        val indices = ArrayList<Int>()
        val sides = listOf(
            Vector3f(1f, 0f, 0f), Vector3f(-1f, 0f, 0f), Vector3f(0f, 1f, 0f),
            Vector3f(0f, -1f, 0f), Vector3f(0f, 0f, 1f), Vector3f(0f, 0f, -1f)
        )
        for (n in sides) {
            val u = if (n.y == 0f) Vector3f(n.z, 0f, -n.x) else Vector3f(1f, 0f, 0f)
            val v = Vector3f(n).cross(u)
            val first = vertices.size / 8
            for ((a, b) in listOf(-1f to -1f, 1f to -1f, 1f to 1f, -1f to 1f)) {
                val p = Vector3f(n).fma(a, u).fma(b, v)
                vertices += listOf(p.x, p.y, p.z, (a + 1f) / 2f, (b + 1f) / 2f, n.x, n.y, n.z)
            }
            indices += listOf(first, first + 1, first + 2, first, first + 2, first + 3)
        }
        return Mesh(vertices.toFloatArray(), indices.toIntArray(), attributes, material)
    }
}
