package cga.exercise.game

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** Meshes that need no file. */
object Shapes {
    val ATTRIBUTES = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    fun sphere(material: Material, rings: Int = 16, sectors: Int = 24): Mesh {
        val vertices = ArrayList<Float>()
        val indices = ArrayList<Int>()
        for (r in 0..rings) for (s in 0..sectors) {
            val theta = PI * r / rings
            val phi = 2.0 * PI * s / sectors
            val x = (sin(theta) * sin(phi)).toFloat()
            val y = cos(theta).toFloat()
            val z = (sin(theta) * cos(phi)).toFloat()
            vertices += listOf(x, y, z, s.toFloat() / sectors, 1.0f - r.toFloat() / rings, x, y, z)
        }
        for (r in 0 until rings) for (s in 0 until sectors) {
            val a = r * (sectors + 1) + s
            val b = a + sectors + 1
            indices += listOf(a, b, b + 1, a, b + 1, a + 1)
        }
        return Mesh(vertices.toFloatArray(), indices.toIntArray(), ATTRIBUTES, material)
    }

    /** From -1 to 1, with a face of its own for each side. */
    fun box(material: Material): Mesh {
        val vertices = ArrayList<Float>()
        val indices = ArrayList<Int>()
        // normal, right and up of each side
        val sides = arrayOf(
            intArrayOf(0, 0, 1, 1, 0, 0, 0, 1, 0), intArrayOf(0, 0, -1, -1, 0, 0, 0, 1, 0),
            intArrayOf(1, 0, 0, 0, 0, -1, 0, 1, 0), intArrayOf(-1, 0, 0, 0, 0, 1, 0, 1, 0),
            intArrayOf(0, 1, 0, 1, 0, 0, 0, 0, -1), intArrayOf(0, -1, 0, 1, 0, 0, 0, 0, 1)
        )
        for (side in sides) {
            val first = vertices.size / 8
            for ((a, b) in listOf(-1 to -1, 1 to -1, 1 to 1, -1 to 1)) {
                for (i in 0..2) vertices += (side[i] + a * side[3 + i] + b * side[6 + i]).toFloat()
                vertices += listOf((a + 1) / 2.0f, (b + 1) / 2.0f)
                for (i in 0..2) vertices += side[i].toFloat()
            }
            indices += listOf(first, first + 1, first + 2, first, first + 2, first + 3)
        }
        return Mesh(vertices.toFloatArray(), indices.toIntArray(), ATTRIBUTES, material)
    }
}
