package cga.reference

import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.testing.assertNear
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import kotlin.math.abs

/** Whole pictures. */
class ReferenceRendererTest {
    private val scene = ScriptedScene(96, 54, Step.FINAL).apply { advanceTo(5.3) }.scene
    private val renderer = ReferenceRenderer(scene.frame(), 96, 54)

    @Test
    fun `any number of threads gives the same numbers`() {
        val alone = renderer.render(threads = 1)
        for (threads in listOf(2, 5)) {
            val together = renderer.render(threads = threads)
            assertArrayEquals(alone.rgb, together.rgb)
            assertArrayEquals(alone.surface, together.surface)
            assertArrayEquals(alone.depth, together.depth)
        }
    }

    @Test
    fun `a probe tells what is in the picture`() {
        val picture = renderer.render()
        var hits = 0
        for (row in 0 until 54 step 7) {
            for (column in 0 until 96 step 5) {
                val pixel = row * 96 + column
                val point = renderer.probe(column, row)
                if (picture.surface[pixel] == ReferencePicture.NO_SURFACE) {
                    assertNull(point)
                    assertEquals(1.0, picture.depth[pixel])
                    continue
                }
                assertNotNull(point)
                hits++
                assertNear(Vector3d(picture.rgb[3 * pixel], picture.rgb[3 * pixel + 1], picture.rgb[3 * pixel + 2]), point!!.color, 0.0)
                assertEquals(picture.depth[pixel], point.depth)
                val parts = point.lights.fold(
                    point.emission.add(point.ambient, Vector3d()),
                ) { sum, it -> sum.add(it.diffuse).add(it.specular) }
                assertNear(parts, point.radiance, 0.0)
            }
        }
        assertTrue(hits > 50)
        assertThrows<IllegalArgumentException> { renderer.probe(96, 0) }
    }

    @Test
    fun `n×n samples are the mean of a picture n times as large`() {
        val large = ReferenceRenderer(scene.frame(), 3 * 96, 3 * 54).render()
        val small = renderer.render(grid = 3)
        for (pixel in 0 until 96 * 54) {
            for (c in 0..2) {
                val samples = List(9) { large.rgb[3 * ((3 * (pixel / 96) + it / 3) * 288 + 3 * (pixel % 96) + it % 3) + c] }
                // The two round window coordinates differently, which moves texture coordinates by some 1e-14.
                assertNear(samples.average(), small.rgb[3 * pixel + c], 1e-9)
            }
        }
        assertArrayEquals(renderer.render().surface, small.surface)
    }

    @Test
    fun `more samples come closer to the covered area`() {
        // The lower left half of the picture, cut along a slope of 3/7.
        val vertices = vertex(-1.0, -1.0) + vertex(1.0, -1.0) + vertex(1.0, -1.0 + 6.0 / 7) + vertex(-1.0, -1.0)
        val half = ReferenceRenderer(frame(draw(vertices, intArrayOf(0, 1, 2))), 7, 7)
        val errors = listOf(1, 2, 4, 8, 16).map { grid -> abs(half.render(grid).rgb.sum() / 3 - 49 * 3 / 14.0) }
        assertTrue(errors.last() < 0.1 && errors.last() < errors.first() / 4) { "$errors" }
    }

    @Test
    fun `the scene's own state is drawn, emission as its texture times the tint`() {
        val frame = frame(draw(vertex(-3.0, -1.0) + vertex(3.0, -1.0) + vertex(0.0, 5.0), tint = Vector3f(0.5f, 2f, -1f)))
        val picture = ReferenceRenderer(frame, 3, 2).render()
        assertEquals(listOf(0.5, 2.0, -1.0), picture.rgb.toList().subList(0, 3))
        assertEquals(listOf<Byte>(-128, -1, 0, -1), picture.toImageData().rgba.toList().subList(0, 4))
        assertEquals(listOf(0.5f, 2f, -1f, 1f), picture.toFloatImage().rgba.toList().subList(0, 4))
    }

    @Test
    fun `normals stay perpendicular under uneven scale and point outwards when mirrored`() {
        // The plane x + z = 0 in the model; scaled by 2 along x its normal is (1, 0, 2)/√5. Mirrored in x the triangle turns its back.
        val corners = listOf(Vector3f(-0.5f, -1f, 0.5f), Vector3f(0.5f, -1f, -0.5f), Vector3f(0f, 1f, 0f))
        val vertices = corners.flatMap { listOf(it.x, it.y, it.z, 0f, 0f, 1f, 0f, 1f) }.toFloatArray()
        for ((model, indices, normal) in listOf(
            Triple(Matrix4d().scale(2.0, 1.0, 1.0), intArrayOf(0, 1, 2), Vector3d(1.0, 0.0, 2.0)),
            Triple(Matrix4d().scale(-2.0, 1.0, 1.0), intArrayOf(0, 2, 1), Vector3d(-1.0, 0.0, 2.0)),
            Triple(
                Matrix4d().scale(2.0, 1.0, 1.0).scaleLocal(1e-13, 1.0, 1.0).scaleLocal(1e13, 1.0, 1.0),
                intArrayOf(0, 1, 2),
                Vector3d(1.0, 0.0, 2.0),
            ),
        )) {
            val point = ReferenceRenderer(frame(draw(vertices, indices, model)), 8, 8).probe(4, 4)
            assertNotNull(point)
            assertNear(normal.normalize(), point!!.normal, 1e-15, "$model")
        }
    }

    @Test
    fun `a picture without draws is black`() {
        val picture = ReferenceRenderer(frame(), 17, 5).render(grid = 2)
        assertTrue(picture.rgb.all { it == 0.0 } && picture.surface.all { it == ReferencePicture.NO_SURFACE })
    }
}
