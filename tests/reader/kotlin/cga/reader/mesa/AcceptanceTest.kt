package cga.reader.mesa

import cga.reader.Reading
import cga.reader.shader.Stage
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*

/** What Mesa takes can be read, as far as it was thought of; of the rest shaderc takes some. */
@ExtendWith(Offscreen::class)
class AcceptanceTest {
    @Test
    fun `what Mesa takes is read`() {
        val taken = TEXTS.filter(::isTaken)
        assertTrue(taken.size >= 24) { "only ${taken.size} of ${TEXTS.size} are taken: $taken" }
        assertEquals(emptyList<String>(), taken.filter { Reading.of("x", it, Stage.FRAGMENT) !is Reading.Done })
    }

    private fun isTaken(text: String): Boolean {
        val shader = glCreateShader(GL_FRAGMENT_SHADER)
        glShaderSource(shader, text)
        glCompileShader(shader)
        return (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE).also { glDeleteShader(shader) }
    }

    private companion object {
        val VERSIONS =
            listOf(
                "#version 330\nin vec3 n;\nvoid main() { gl_FragColor = vec4(n, 1.0); }",
                "#version 330 core\nin vec3 n;\nvoid main() { gl_FragData[0] = vec4(n, 1.0); }",
                "#version 150 core\nin vec3 n; out vec4 c;\nvoid main() { c = vec4(n, 1); }",
                "#version 130\nin vec3 n; out vec4 c;\nvoid main() { c = vec4(n, 1); }",
                "#version 120\nvarying vec3 n;\nvoid main() { gl_FragColor = vec4(n, 1); }",
                "varying vec3 n; uniform sampler2D t;\nvoid main() { gl_FragColor = texture2D(t, n.xy); }",
                "#version 300 es\nprecision mediump float; in vec3 n; out vec4 c;\nvoid main() { c = vec4(n, 1); }",
            )
        val WAYS =
            listOf(
                "#define LIGHTS 3\n#if LIGHTS > 2\nin vec3 n;\n#endif\nout vec4 c;\nvoid main() { c = vec4(n, LIGHTS); }",
                "#extension GL_FOO_bar : enable\n#pragma optimize(on)\nin vec3 n; out vec4 c;\nvoid main() { c = vec4(n, 1); }",
                "#extension GL_ARB_explicit_uniform_location : enable\nlayout(location = 1) uniform vec3 t; out vec4 c;\nvoid main() { c = vec4(t, 1); }",
                "#extension GL_ARB_shading_language_420pack : enable\nlayout(binding = 1) uniform sampler2D t; out vec4 c;\nvoid main() { c = texture(t, vec2(0)); }",
                "varying vec3 n; out vec4 c;\nvoid main() { c = vec4(n, 1); }",
                "uniform vec3 a[]; out vec4 c;\nvoid main() { c = vec4(a[2], 1); }",
                "uniform float a[4]; out vec4 c;\nvoid main() { c = vec4(0); for (int i = 0; i < a.length(); i++) c += a[i]; }",
                "in vec3 n; out vec4 c; vec3 q = n;\nvoid main() { c = vec4(q, 1); }",
                "in vec3 n; out vec4 c;\nvoid main() { c = vec4(n * 2, 1); c += c; if (n.x == 3) c = vec4(max(n, 0), pow(n.y, 2)); }",
                "in vec3 n; out vec4 c; float f(float x) { if (x > 0.0) return 1.0; }\nvoid main() { c = vec4(f(n.x)); }",
                "struct M { sampler2D t; float s; }; uniform M m[2]; in vec3 n; out vec4 c;\nvoid main() { c = texture(m[1].t, n.xy) * m[1].s; }",
                "in vec3 n; out vec4 c; float saturate(float x) { return clamp(x, 0.0, 1.0); }\nvoid main() { c = vec4(saturate(n.x)); };",
                "in vec3 n; out vec4 c;;\nvoid main() { vec3 reflect = reflect(n, n); float distance = length(n); c = vec4(reflect, distance); }",
                "// größer\nuniform struct L { vec3 p; } l; in struct K { vec3 p; } k; out vec4 c;\nvoid main() { c = vec4(k.p + l.p, 1); }",
                "struct L { vec3 p; }; struct L { vec3 p; }; uniform L l; out vec4 c;\nvoid main() { c = vec4(l.p, 1); }",
                "in vec3 n; out vec4 c; out vec4 d;\nvoid main() { c = vec4(n, 1); d = c; }",
                "layout(origin_upper_left) in vec4 gl_FragCoord; out vec4 c; const float a[] = float[](1.0, 2.0);\nvoid main() { c = gl_FragCoord * a[1]; }",
                "uniform bool b; out vec4 c; void f(inout vec2 v) { v += 1; }\nvoid main() { c = vec4(b); f(c.zx); uint u = 3u; c.x = u; }",
                "out vec4 c; uniform vec3 arr[2] = vec3[](vec3(1), vec3(2)); uniform mat3 m = mat3(2.0);\nvoid main() { c = vec4(m * arr[1], 1); }",
            )
        val TEXTS = VERSIONS + WAYS.map { "#version 330 core\n$it" }
    }
}
