package cga.reader.mesa

import cga.reader.shader
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.lwjgl.opengl.GL33C.*
import kotlin.random.Random

/** What GLSL 3.30 can say, a little of it at a time, is what Mesa draws. */
@ExtendWith(Offscreen::class)
class FeatureComparisonTest {
    @BeforeEach
    fun bindVertexArray() = glBindVertexArray(glGenVertexArrays())

    @ParameterizedTest
    @ValueSource(
        strings = [
            // Functions, each within what floats may be off.
            "color = vec4(sin(n), cos(n.x * 9.0)); color.x += tan(n.y);",
            "color = vec4(asin(n.x * 0.4), acos(n.y * 0.4), atan(n.z), atan(n.x, n.y));",
            "color = vec4(sinh(n.x), cosh(n.y), tanh(n.z), asinh(n.x)) + vec4(acosh(f + 1.0), atanh(n.x * 0.4), 0.0, 0.0);",
            "color = vec4(exp(n.x), exp2(n.y), log(f), log2(f));",
            "color = vec4(pow(f, 2.3), sqrt(f), inversesqrt(f), pow(f, 60.0));",
            "color = vec4(abs(n), sign(n.x)) + vec4(floor(n * 5.0), ceil(n.z)) + vec4(trunc(n), round(n.x)) + fract(n.y * 3.0);",
            "color = vec4(mod(n * 7.0, 1.5), mod(-f, f * 0.7)) + roundEven(n.x * 4.0); float whole; color.y += modf(n.z * 3.0, whole) + whole;",
            "color = vec4(min(n, 0.5), max(n.x, n.y)) + vec4(clamp(n, 0.0, 1.0), clamp(f, 0.5, 0.6)) + vec4(mix(n, p, f), mix(1.0, f, n.x > 0.0));",
            "color = vec4(step(n, p), step(0.5, f)) + vec4(smoothstep(-1.0, 1.0, n), smoothstep(0.0, f, n.x));",
            "color = vec4(length(n), distance(n, p), dot(n, p), length(f)) + vec4(cross(n, p), 1.0) + vec4(normalize(n), 0.0);",
            "color = vec4(reflect(n, normalize(p)), 1.0) + vec4(refract(normalize(n), normalize(p), 0.7), 1.0) + vec4(faceforward(n, p, n + p), 0.0);",
            "color = vec4(radians(n), degrees(n.x)) + vec4(isnan(n.x / f), isinf(n.y), any(lessThan(n, p)), all(greaterThanEqual(n, p)));",
            "color = vec4(vec3(not(equal(n, p))), 1.0) + vec4(notEqual(ivec4(k), ivec4(1, 2, 3, 0))) + float(n == p) + float(n != p);",
            // Integers.
            "int i = k * 1000003; i = i * i - 7 / (k + 1) + (i % 5 < 0 ? 1 : 2); color = vec4(i & 255, i | 3, i ^ 77, ~i);",
            "uint u = uint(k) * 4000000000u + 5u; color = vec4(u >> 3u, u << 2u, u / 7u, u % 10u); color.x += float(-k >> 1) + float(u > 7u);",
            "color = vec4(int(n.x * 9.0), uint(f * 9.0), float(k), bool(k)); color += vec4(ivec3(n * 5.0), min(k, 1)) + float(abs(-k) + sign(-k));",
            "color = vec4(intBitsToFloat(floatBitsToInt(n.x)), uintBitsToFloat(floatBitsToUint(f)), max(k, 1), clamp(k, 1, 2));",
            // Matrices.
            "color = vec4(m * n, 1.0) + vec4(n * m, 2.0) + vec4((m * m)[1], 0.0) + vec4(transpose(m)[2], determinant(m));",
            "color = vec4(inverse(m) * n, 1.0) + vec4(outerProduct(n, p)[1], 1.0) + vec4(matrixCompMult(m, m)[0], m[1][2]);",
            "mat4 q = mat4(m); q[3] = vec4(n, 1.0); color = inverse(q) * vec4(p, 1.0) + determinant(q) + vec4(mat2(m) * n.xy, mat3(2.0)[1].yz);",
            "mat4x3 a = mat4x3(n, p, n + p, n - p); color = vec4(a * vec4(p, f), 1.0) + (p * a) + vec4((-a)[k], 1.0) + vec4((a + a * f - 1.0)[1], 0.0);",
            // What is put together and picked out, with computed indices as well.
            "vec4 v = vec4(n.zx, p.yy); v.yw += v.xz; v[k] = 3.0; mat3 w = m; w[k] = n; w[1][k] = 5.0; color = v.wzyx + vec4(w * p, v[k + 1]);",
            "float a[4] = float[4](1.0, n.x, f, 2.0); a[k] *= 3.0; const vec2 b[3] = vec2[](vec2(1), vec2(2), vec2(3)); color = vec4(a[k + 1], b[k], a.length());",
            "S s = S(n, float[2](1.0, 2.0)); S t = s; t.v.y = f; t.a[k % 2] = 9.0; color = vec4(t.v, t.a[0] + s.a[1]) + float(s == t);",
            // Branches, loops, functions.
            "float x = 0.0; for (int i = 0; i < 9; i++) { if (i == k) continue; if (i > 5) break; x += float(i) * f; } color = vec4(x);",
            "float x = f; while (x < 20.0) x *= 1.7; do { x -= 3.0; } while (x > 4.0); color = vec4(x); if (n.x > 1.0) discard;",
            "color = n.x > 0.0 && p.x > 0.5 || f < 1.0 ? vec4(n, 1.0) : vec4(p, f); if (n.y < 0.0 != p.y < 0.5 ^^ b) color *= 2.0;",
            "switch (k) { case 0: color = vec4(n, 1.0); case 1: color += vec4(p, f); break; default: color = vec4(-n, 1.0); }",
            "vec2 v = n.xy; float x; float r = twist(v, k, x); color = vec4(v, x, r) + early(n.x) + early(early(p.y) * 2.0);",
            "color = vec4(counter()); color += counter() * vec4(f); color.w += counter(); color.xyz += global;",
            "color = gl_FrontFacing ? gl_FragCoord : vec4(0.0);",
            "color = block.scale[k] * vec4(block.turn * n, loose) + vec4(lights[k % 2].place, lights[1].weights[k]) + initial;",
        ],
    )
    fun `a piece of GLSL computes what Mesa draws`(body: String) {
        val text = "#version 330 core\n$DECLARATIONS\nvoid main() { color = vec4(0.0);\n$body }\n"
        val compared = compareFragments(body, text, shader(text), POINTS, Random(3))
        assertEquals(emptyList<String>(), compared.wrong)
        assertTrue(compared.numbers > 3 * compared.open) { "$compared" }
    }

    private companion object {
        const val POINTS = 40
        val DECLARATIONS =
            """
            in vec3 n;
            flat in vec3 p;
            uniform float f;
            uniform int k;
            uniform bool b;
            uniform mat3 m;
            uniform float initial = 2.5;
            struct S { vec3 v; float a[2]; };
            struct Light { vec3 place; float weights[3]; };
            uniform Light lights[2];
            layout(std140) uniform Block { mat3 turn; vec4 scale[3]; } block;
            layout(std140) uniform Plain { float loose; };
            out vec4 color;
            vec3 global = vec3(1.0, 2.0, 3.0);
            float twist(inout vec2 v, const int by, out float x) {
                v = v.yx * float(by);
                x = v.x + global.y;
                return v[by % 2];
            }
            float early(float x) {
                if (x > 0.5) return 1.0;
                for (int i = 0; i < 4; i++) if (float(i) > x * 8.0) return float(i);
                return x;
            }
            float counter() { global.x += 1.0; return global.x; }
            """.trimIndent()
    }
}
