package cga.exercise.components.geometry

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** A sphere of radius 1 with positions only, for the lamps. */
fun sphereMesh(rings: Int = 10, segments: Int = 16): Mesh {
    val vertices = ArrayList<Float>()
    val indices = ArrayList<Int>()
    for (i in 0..rings) for (j in 0..segments) {
        val theta = (PI * i / rings).toFloat()
        val phi = (2.0 * PI * j / segments).toFloat()
        vertices += listOf(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi))
    }
    for (i in 0 until rings) for (j in 0 until segments) {
        val a = i * (segments + 1) + j
        val b = a + segments + 1
        indices += listOf(a, b, a + 1, a + 1, b, b + 1)
    }
    return Mesh(vertices.toFloatArray(), indices.toIntArray(), arrayOf(VertexAttribute(3, 12, 0)))
}
