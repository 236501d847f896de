package cga.measure.speed

import kotlin.random.Random

/**
 * The order in which a mesh's triangles are drawn, three indices a triangle. It changes no picture of a closed mesh, but how often a
 * vertex is shaded.
 */
internal object TriangleOrder {
    /** The vertices that post-transform caches of real GPUs hold, about. */
    const val CACHE = 16

    /** Vertices shaded a triangle (average cache miss ratio, Hoppe 1999): 3 at worst, about 0.5 at best. First in, first out. */
    fun cacheMisses(indices: IntArray): Double {
        val cache = LinkedHashSet<Int>()
        var misses = 0
        for (vertex in indices) {
            if (vertex in cache) continue
            misses++
            if (cache.size == CACHE) cache.remove(cache.first())
            cache += vertex
        }
        return misses / (indices.size / 3.0)
    }

    /** The same triangles in an order without any sense. */
    fun shuffled(indices: IntArray): IntArray = ordered(indices, (0 until indices.size / 3).shuffled(Random(1)))

    /** Fan after fan, each about a vertex that is still in the cache: tipsify (Sander, Nehab, Barczak 2007). */
    fun forCache(indices: IntArray): IntArray {
        val fans = Fans(indices)
        return ordered(indices, fans.order())
    }

    private fun ordered(
        indices: IntArray,
        triangles: List<Int>,
    ): IntArray = IntArray(indices.size) { indices[3 * triangles[it / 3] + it % 3] }

    private class Fans(private val indices: IntArray) {
        private val vertices = (indices.maxOrNull() ?: -1) + 1
        private val triangles = List(vertices) { ArrayList<Int>() }.also { of -> indices.forEachIndexed { i, v -> of[v] += i / 3 } }
        private val left = IntArray(vertices) { triangles[it].size }
        private val entered = IntArray(vertices)
        private val isDrawn = BooleanArray(indices.size / 3)
        private val recent = ArrayDeque<Int>()
        private var time = CACHE + 1
        private var next = 0

        fun order(): List<Int> {
            val order = ArrayList<Int>()
            var center = fresh()
            while (center >= 0) {
                val ring = ArrayList<Int>()
                for (triangle in triangles[center].filter { !isDrawn[it] }) {
                    order += triangle
                    draw(triangle, ring)
                }
                center = best(ring)
            }
            return order
        }

        private fun draw(
            triangle: Int,
            ring: MutableList<Int>,
        ) {
            isDrawn[triangle] = true
            for (i in 3 * triangle until 3 * triangle + 3) {
                val vertex = indices[i]
                ring += vertex
                recent.addLast(vertex)
                left[vertex]--
                if (time - entered[vertex] > CACHE) entered[vertex] = time++
            }
        }

        /** The vertex that entered the cache longest ago, of those that will still be in it when all their triangles are drawn. */
        private fun best(ring: List<Int>): Int {
            val staying = ring.filter { left[it] > 0 && time - entered[it] + 2 * left[it] <= CACHE }
            return staying.maxByOrNull { time - entered[it] } ?: ring.find { left[it] > 0 } ?: fresh()
        }

        /** One seen lately, else the first with triangles left; −1 for none. */
        private fun fresh(): Int {
            while (recent.isNotEmpty()) recent.removeLast().let { if (left[it] > 0) return it }
            while (next < vertices && left[next] == 0) next++
            return if (next < vertices) next else -1
        }
    }
}
