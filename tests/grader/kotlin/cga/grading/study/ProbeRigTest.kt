package cga.grading.study

import cga.grading.capture.CapturedProgram
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
class ProbeRigTest {
    private val vertex =
        """
        #version 330 core
        layout(location = 0) in vec3 position;
        out vec3 p;
        uniform float factor;
        void main() { p = position; gl_Position = vec4(position * factor, 2.0); }
        """.trimIndent()
    private val fragment =
        """
        #version 330 core
        in vec3 p;
        uniform sampler2D map;
        out vec4 color;
        void main() { if (p.x < -5.0) discard; color = vec4(p + texture(map, p.xy).rgb, 1.0); }
        """.trimIndent()

    private fun <T> probed(block: (ProbeRig, ProbeProgram) -> T): T =
        ProbeRig().use { rig -> ProbeProgram(CapturedProgram(vertex, fragment, mapOf("position" to 0))).use { block(rig, it) } }

    private fun feed(vararg points: List<Double>) = Feed(
        points.size,
    ).also { feed -> points.forEachIndexed { i, (x, y, z) -> feed.set(0, i, x, y, z) } }

    @Test
    fun `each vertex is shaded by itself, beyond 1 and below 0`() =
        probed { rig, program ->
            val shades = rig.points(
                program,
                feed(listOf(2.0, -1.0, 0.5), listOf(0.0, 8.0, 0.0)),
                emptyMap(),
                mapOf("map" to floatArrayOf(1f, 0.5f, 0f)),
            )
            assertArrayEquals(floatArrayOf(3f, -0.5f, 0.5f, 1f, 1f, 8.5f, 0f, 1f), shades)
        }

    @Test
    fun `a discarded fragment is no number`() =
        probed { rig, program -> assertTrue(rig.points(program, feed(listOf(-6.0, 0.0, 0.0)), emptyMap(), emptyMap())[0].isNaN()) }

    @Test
    fun `the middle of a triangle is the mean of its corners`() =
        probed { rig, program ->
            val shades = rig.triangles(
                program,
                feed(listOf(3.0, 0.0, 0.0), listOf(0.0, 6.0, 0.0), listOf(0.0, 0.0, 9.0)),
                emptyMap(),
                emptyMap(),
            )
            // Three products and their sum, each rounded, of weights that the driver rounds too.
            listOf(1f, 2f, 3f).forEachIndexed { i, expected -> assertEquals(expected, shades[i], 1e-5f) }
        }

    @Test
    fun `the place that the program gives a vertex is seen although it is drawn elsewhere`() =
        probed { rig, program ->
            assertArrayEquals(
                floatArrayOf(3f, 6f, -3f, 2f),
                rig.clip(program, feed(listOf(1.0, 2.0, -1.0)), mapOf("factor" to floatArrayOf(3f))),
            )
        }
}
