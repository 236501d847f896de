package cga.grading.study

import cga.grading.capture.CapturedProgram
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
class LiftedConstantsTest {
    @Test
    fun `constant vectors become uniforms that hold them`() {
        val lifted = LiftedConstants.of("#version 330 core\nconst vec3 a = vec3(1.0, -2, .5f); // vec3(9.0)\nvec4 b = vec4(2.0);", "c")
        assertArrayEquals(floatArrayOf(1f, -2f, 0.5f), lifted.values["c0"])
        assertArrayEquals(floatArrayOf(2f, 2f, 2f, 2f), lifted.values["c1"])
        assertEquals(2, lifted.values.size)
        assertEquals("vec3(1.0,-2,.5f)", lifted.texts["c0"])
    }

    @Test
    fun `black is no colour`() {
        val lifted = LiftedConstants.of("#version 330 core\nvec3 a = vec3(0.0); vec4 b = vec4(0, 0, 0, 1.0);", "c")
        assertEquals(emptySet<String>(), lifted.values.keys)
    }

    @Test
    fun `vectors that are made of numbers or named are multiplied by 1 where it goes deep`() {
        val source =
            "#version 330 core\nuniform float r;\nuniform vec3 u = vec3(r, r, r);\n" +
                "vec3 f() { vec3 a = sin(u), b; vec3 c = cos(u); return vec3(r, r * 2.0, (r)); }"
        val lifted = LiftedConstants.of(source, "c", isDeep = true)
        assertEquals(listOf("cm0", "cm1", "cm2"), lifted.deep)
        assertEquals(true, "return (cm1 * vec3(r, r * 2.0, (r)));" in lifted.source, lifted.source)
        assertEquals(true, "vec3 c = cm2 * (cos(u));" in lifted.source, lifted.source)
        assertEquals(true, "vec3 a = sin(u), b;" in lifted.source, lifted.source)
        assertArrayEquals(floatArrayOf(1f, 1f, 1f), lifted.values["cm0"])
    }

    @Test
    fun `what may size an array stays constant`() {
        val lifted = LiftedConstants.of("#version 330 core\nconst int N = 3;\nuniform vec3 a[N];\nconst float b = 2.0;", "c")
        assertEquals(true, "const int N = 3;" in lifted.source)
        assertEquals(false, "const float" in lifted.source)
    }

    @Test
    fun `a lifted program draws the same and with other values something else`() {
        val main = "void main() { p = position; gl_Position = vec4(position, 1.0); }"
        val vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nout vec3 p;\n$main"
        val fragment =
            """
            #version 330 core
            in vec3 p;
            const vec3 tint = vec3(0.25, 0.5, 2.0);
            const vec3 both = tint * 2.0;
            out vec4 color;
            void main() { color = vec4(p * tint + both, 1.0); }
            """.trimIndent()
        ProbeRig().use { rig ->
            ProbeProgram(CapturedProgram(vertex, fragment, mapOf("position" to 0))).use { program ->
                val feed = Feed(1)
                feed.set(0, 0, 0.5, 1.0, -1.0)
                val name = program.constants.keys.single()
                // Powers of 2: nothing is rounded.
                val same = rig.points(program, feed, program.constants, emptyMap())
                assertArrayEquals(floatArrayOf(0.625f, 1.5f, 2f, 1f), same)
                val other = rig.points(program, feed, mapOf(name to floatArrayOf(1f, 0f, 0f)), emptyMap())
                assertArrayEquals(floatArrayOf(2.5f, 0f, 0f, 1f), other)
            }
        }
    }
}
