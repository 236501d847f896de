package cga.reference

import cga.framework.Frame
import cga.framework.FrameDraw
import cga.testing.assertNear
import org.joml.Matrix4f
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.random.Random

/** Which pixels a triangle covers, and what it says there. */
class CoverageTest {
    @Test
    fun `the triangles of a fan cover every pixel exactly once, also where edges run through centres`() {
        val random = Random(1)
        repeat(20) { round ->
            // Corners at multiples of half a pixel, so that many pixel centres lie on edges, and the hub of many a fan on one.
            val hub = Pair(random.nextInt(20, 108) / 2.0, random.nextInt(20, 108) / 2.0)
            val rim = listOf(-8.0 to -8.0, 72.0 to -8.0, 72.0 to 72.0, -8.0 to 72.0) + List(12) { onRim(random) }
            val around = rim.distinct().sortedBy { atan2(it.second - hub.second, it.first - hub.first) }
            val triangles = around.indices.flatMap { listOf(hub, around[it], around[(it + 1) % around.size]) }
            val counts = counts(frame(draw(triangles.flatMap { atWindow(it.first, it.second).toList() }.toFloatArray())))
            assertTrue(counts.all { it == 1 }) { "round $round, hub $hub: covered ${counts.toSet()} times" }
        }
    }

    @Test
    fun `a square takes the centres on its left and upper edge and leaves those on the others`() {
        fun covered(left: Double, bottom: Double, right: Double, top: Double): Set<Pair<Int, Int>> {
            val counts = counts(frame(square(left, bottom, right, top)))
            return counts.indices.filter { counts[it] > 0 }.map { it % SIZE to it / SIZE }.toSet()
        }
        assertEquals(setOf(3 to 4, 4 to 4), covered(3.5, 3.5, 5.5, 4.5))
        assertEquals(setOf(3 to 3, 4 to 3), covered(3.25, 3.25, 4.75, 3.75))
        assertEquals(emptySet<Any>(), covered(3.6, 3.6, 4.4, 4.4))
    }

    @Test
    fun `back faces and triangles without an area are not drawn`() {
        val back = listOf(10.0 to 10.0, 10.0 to 50.0, 50.0 to 10.0)
        val line = listOf(10.0 to 10.0, 30.0 to 30.0, 50.0 to 50.0)
        for (corners in listOf(back, line)) {
            val draw = draw(corners.flatMap { atWindow(it.first, it.second).toList() }.toFloatArray())
            assertTrue(ReferenceRenderer(frame(draw), SIZE, SIZE).render().surface.all { it == ReferencePicture.NO_SURFACE })
        }
    }

    @Test
    fun `of two surfaces the nearer is seen, and of two at the same depth the first`() {
        fun seen(vararg depths: Double) =
            ReferenceRenderer(frame(*depths.map { square(0.0, 0.0, 64.0, 64.0, it) }.toTypedArray()), SIZE, SIZE).probe(5, 5)?.draw
        assertEquals(1, seen(0.5, 0.25))
        assertEquals(0, seen(0.25, 0.5))
        assertEquals(0, seen(0.25, 0.25))
        // At the far plane a depth of 1 is not less than the 1 that the buffer is cleared to; the near plane belongs to the picture.
        assertEquals(null, seen(1.0))
        assertEquals(0, seen(-1.0))
        assertEquals(null, seen(-1.0001))
    }

    @Test
    fun `a ground that goes on behind the eye is seen once in each pixel, between the near and the far plane`() {
        val (near, far) = 1.25 to 20.0
        val projection = Matrix4f().setPerspective((PI / 2).toFloat(), 1f, near.toFloat(), far.toFloat())
        val frame = frame(ground(), projection = projection)
        val counts = counts(frame)
        for (y in 0 until SIZE) {
            for (x in 0 until SIZE) {
                val z = hit(x, y, projection).z
                val expected = if (z < 0 && -z in near..far) 1 else 0
                assertEquals(expected, counts[y * SIZE + x], "pixel ($x, $y), where the ground is at z = $z")
            }
        }
        // 1.25 and 20 away the ground is 0.8 and 0.05 below the middle of a picture that is 2 high: 24 rows.
        assertEquals(24 * SIZE, counts.sum())
    }

    @Test
    fun `interpolation is perspective-correct, and so are its derivatives`() {
        val projection = Matrix4f().setPerspective((PI / 2).toFloat(), 1f, 0.1f, 100f)
        val renderer = ReferenceRenderer(frame(ground(), projection = projection), SIZE, SIZE)
        for ((x, y) in listOf(0 to 0, 31 to 5, 63 to 20, 17 to 29)) {
            val point = requireNotNull(renderer.probe(x, SIZE - 1 - y))
            val expected = hit(x, y, projection)
            // Numbers up to 20 from homogeneous coordinates up to 64·20, a few roundings of each.
            assertNear(expected, point.position, 1e-12, "($x, $y)")
            // Texture coordinates are x and z of the ground. z = −t and x = dirx·t with t = 1/−diry, and only dirx depends on X.
            val t = -expected.z
            assertNear(expected.x, point.texCoord.x, 1e-12)
            assertNear(expected.z, point.texCoord.y, 1e-12)
            assertNear(2.0 / SIZE / projection.m00() * t, point.texCoordDx.x, 1e-12)
            assertNear(0.0, point.texCoordDx.y, 1e-12)
            val dtdy = t * t * 2 / SIZE / projection.m11()
            assertNear(-dtdy, point.texCoordDy.y, 1e-11)
            assertNear(dtdy * expected.x / t, point.texCoordDy.x, 1e-11)
        }
    }

    @Test
    fun `depth is linear in the window`() {
        val slope = listOf(atWindow(0.0, 0.0, -1.0), atWindow(128.0, 0.0, 1.0), atWindow(0.0, 128.0, 0.0))
        val picture = ReferenceRenderer(frame(draw(slope.reduce { a, b -> a + b })), SIZE, SIZE).render()
        for ((x, y) in listOf(0 to 0, 30 to 7, 11 to 51)) {
            val z = -1 + 2 * (x + 0.5) / 128 + (y + 0.5) / 128
            assertNear((z + 1) / 2, picture.depth[(SIZE - 1 - y) * SIZE + x], 1e-14)
        }
    }

    /** A point on the edge of the square from −8 to 72. */
    private fun onRim(random: Random): Pair<Double, Double> {
        val along = random.nextInt(-16, 145) / 2.0
        val side = if (random.nextBoolean()) -8.0 else 72.0
        return if (random.nextBoolean()) along to side else side to along
    }

    /** How many triangles cover each pixel, rows from the lowest. */
    private fun counts(frame: Frame): IntArray {
        val triangles = Triangles(frame, SIZE, SIZE)
        val projected = Projected()
        val counts = IntArray(SIZE * SIZE)
        for (number in 0 until triangles.count) {
            projected.look(triangles, number)
            for (pixel in counts.indices) {
                projected.at(pixel % SIZE + 0.5, pixel / SIZE + 0.5)
                if (projected.isFront && projected.covers) counts[pixel]++
            }
        }
        return counts
    }

    private fun square(left: Double, bottom: Double, right: Double, top: Double, z: Double = 0.0): FrameDraw =
        draw(
            listOf(
                left to bottom,
                right to bottom,
                right to top,
                left to top,
            ).flatMap { atWindow(it.first, it.second, z).toList() }.toFloatArray(),
            intArrayOf(0, 1, 2, 0, 2, 3),
        )

    /** The vertex that is seen at the window point ([x], [y]). */
    private fun atWindow(x: Double, y: Double, z: Double = 0.0) = vertex(x / (SIZE / 2) - 1, y / (SIZE / 2) - 1, z)

    /** The plane y = −1 from z = −90 to behind the eye, in uneven strips. */
    private fun ground(): FrameDraw {
        val xs = listOf(-95.0, -31.0, -3.7, -0.1, 0.3, 2.0, 17.0, 95.0)
        val zs = listOf(7.0, 0.5, -0.7, -1.1, -4.0, -13.0, -30.0, -90.0)
        val vertices = zs.flatMap { z -> xs.flatMap { x -> listOf(x, -1.0, z, x, z, 0.0, 1.0, 0.0) } }
        val indices = (0 until zs.size - 1).flatMap { j ->
            (0 until xs.size - 1).flatMap { i ->
                val at = j * xs.size + i
                listOf(at, at + 1, at + xs.size + 1, at, at + xs.size + 1, at + xs.size)
            }
        }
        return draw(vertices.map { it.toFloat() }.toFloatArray(), indices.toIntArray())
    }

    /** Where the ray through the centre of pixel ([x], [y]) meets the plane y = −1; behind the eye for one that goes up. */
    private fun hit(x: Int, y: Int, projection: Matrix4f): Vector3d {
        val ray = Vector3d((2 * (x + 0.5) / SIZE - 1) / projection.m00(), (2 * (y + 0.5) / SIZE - 1) / projection.m11(), -1.0)
        return ray.mul(-1 / ray.y)
    }

    private companion object {
        const val SIZE = 64
    }
}
