package cga.framework

import java.io.File

/** Vertices as position, texture coordinate, normal (8 floats each), and three indices a triangle. */
class OBJMesh(val vertexData: FloatArray, val indexData: IntArray)

/** Reads simple OBJ files: v, vt, vn, and f with all three of them. */
object OBJLoader {
    fun loadOBJ(path: String): OBJMesh {
        val positions = ArrayList<List<Float>>()
        val texCoords = ArrayList<List<Float>>()
        val normals = ArrayList<List<Float>>()
        val known = HashMap<String, Int>()
        val vertices = ArrayList<Float>()
        val indices = ArrayList<Int>()

        fun indexOf(corner: String) = known.getOrPut(corner) {
            val (v, vt, vn) = corner.split("/").map { it.toInt() - 1 }
            vertices += positions[v] + texCoords[vt] + normals[vn]
            known.size
        }

        File(path).forEachLine { line ->
            val words = line.trim().split(Regex("\\s+"))
            val values = words.drop(1)
            when (words[0]) {
                "v" -> positions += values.map { it.toFloat() }
                "vt" -> texCoords += values.take(2).map { it.toFloat() }
                "vn" -> normals += values.map { it.toFloat() }
                "f" -> {
                    val corners = values.map { indexOf(it) }
                    for (i in 2 until corners.size) indices += listOf(corners[0], corners[i - 1], corners[i])
                }
            }
        }
        return OBJMesh(vertices.toFloatArray(), indices.toIntArray())
    }
}
