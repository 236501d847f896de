package cga.grading.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

/** What a fragment shader reads that no vertex shader writes. */
class VaryingsTest {
    private val vertex =
        """
        out vec3 toLight; out vec3 toCamera; // out vec3 inComment;
        flat out vec2 tc[2]; out Data { vec3 inBlock; } data;
        """.trimIndent()

    private fun varyings(fragment: String) = Varyings(vertex, fragment)

    @Test
    fun `stages that fit lack nothing`() {
        val fragment =
            """
            in vec3 toLight, toCamera;
            flat in vec2 tc[2];
            in Data { vec3 inBlock; } d;
            void main() { toLight; toCamera; tc; }
            """.trimIndent()
        assertEquals(emptySet<String>(), varyings(fragment).missing)
    }

    @Test
    fun `what is declared and not read is not missed`() {
        assertEquals(emptySet<String>(), varyings("in vec3 toLamp;\nvoid main() {}").missing)
    }

    @Test
    fun `a name that differs is replaced by the likest of its type that nobody reads`() {
        val varyings = varyings("in vec3 toLights;\nin vec3 toCam;\nvoid main() { f(toLights, toCam); }")
        assertEquals(setOf("toLights", "toCam"), varyings.missing)
        assertEquals("in vec3 toLight;\nin vec3 toCamera;\nvoid main() { f(toLight, toCamera); }", varyings.matched())
    }

    @Test
    fun `another type is no match, nor is what is read already`() {
        assertNull(varyings("in vec4 toLights;\nvoid main() { toLights; }").matched())
        assertNull(varyings("in vec3 toLight, toCamera, toEye;\nvoid main() { toLight; toCamera; toEye; }").matched())
    }

    @Test
    fun `what the vertex shader says in a way of its own is not missed`() {
        assertEquals(emptySet<String>(), Varyings("#define TO_PIXEL out\nTO_PIXEL vec3 n;", "in vec3 n;\nvoid main() { n; }").missing)
    }

    @Test
    fun `what nobody writes is 0, and the rest of its declaration stays`() {
        val fragment = "layout(location = 1) flat in vec3 toLight, toSun; in mat3 m;\nin S s;\nvoid main() { toLight; toSun; m; s; }"
        assertEquals(
            "layout ( location = 1 ) flat in vec3 toLight; vec3 toSun = vec3(0); mat3 m = mat3(0);\nS s;\n" + fragment.lines().last(),
            varyings(fragment).zeroed().lines().joinToString("\n") { it.trim().replace(Regex(" +"), " ") },
        )
    }

    @Test
    fun `the fragment shader says how a vector is interpolated`() {
        val varyings = Varyings("smooth out vec3 n; out vec2 tc;\nout vec3 v;", "in vec3 n; flat in vec2 tc; in vec3 v;")
        assertEquals("out vec3 n; flat out vec2 tc; out vec3 v;", varyings.interpolated().replace(Regex("\\s+"), " "))
    }

    @Test
    fun `what is matched by its location may have another name`() {
        val sent = "layout(location = 1) out vec3 toLight; layout(location = 2) out vec3 toSun;"
        val read = "layout(location = 1) in vec3 l; layout(location = 3) in vec3 s; void main() { l; s; }"
        assertEquals(setOf("s"), Varyings(sent, read).missing)
    }
}
