package cga.reader

import cga.reader.shader.Kind
import cga.reader.shader.Stage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

class ReadingTest {
    @Test
    fun `what is wrong is told with file and line`() {
        assertEquals(
            listOf("my.frag:3: 'lihgt' : undeclared identifier"),
            problems("#version 330 core\nout vec4 c;\nvoid main() { c = vec4(lihgt); }\n").take(1),
        )
    }

    @Test
    fun `a part of a shader is told by what it lacks`() {
        assertTrue("my.frag:2: 'view' : undeclared identifier" in problems("// camera\nvec4 f() { return view * vec4(1.0); }\n"))
    }

    @Test
    fun `a long shader is read in time`() {
        val steps = (0 until 2000).joinToString("\n") { "if (x > $it.5) { x *= 1.01; } else if (x < 0.0) x += 1.0;" }
        val text = "#version 330 core\nin vec3 n; out vec4 c;\nfloat f(float x) {\n$steps\nreturn x; }\n" +
            "void main() { c = vec4(f(n.x), f(n.y), 0.0, 1.0); }"
        assertTrue(text.length > 100_000 && shader(text).size > 20_000)
    }

    @Test
    fun `a shader too large to be taken apart is told`() {
        val twice = (1..20).joinToString("\n") { "float f$it(float x) { return f${it - 1}(x) + f${it - 1}(x + 1.0); }" }
        val text = "#version 330 core\nout vec4 c; in float n; float f0(float x) { return sin(x); }\n$twice\n" +
            "void main() { c = vec4(f20(n)); }"
        assertTrue(
            Regex("my.frag:\\d: cannot be read: more than \\d+ operations, .*").matches(problems(text).single()),
        ) { "${problems(text)}" }
    }

    @ParameterizedTest
    @CsvSource(
        "'#version 330 core|in vec3 n; out vec4 c;|void main() { c = vec4(n, 1f); }', 1f is read as 1.0f",
        "'#version 330 core|uniform sampler2D t; in vec3 n; out vec4 c;|void main() { c = texture2D(t, n.xy); }', texture2D and its like are read as texture",
        "'#version 330 core|struct L { vec3 p; }; struct L { vec3  p; }; uniform L n; out vec4 c;|void main() { c = vec4(n.p, 1); }', " +
            "a structure that is there twice is read once",
        "'#version 330 core|in vec3 n; out vec4 c;|void main() { c = vec4(saturate(max(n, saturate(n.x))), 1.0); }', " +
            "'saturate(x), which NVIDIA has from Cg, is read as clamp(x, 0.0, 1.0)'",
        "'#version 150|in vec3 n; out vec4 c;|void main() { c = vec4(n, 1); }', GLSL 150 is read as 330",
        "'/* old */ varying vec3 n;|  // none|void main() { gl_FragColor = vec4(n, 1.0); }', GLSL 110 is read as 330",
        "'#version 300 es|precision mediump float; in vec3 n; out vec4 c;|void main() { c = vec4(n, 1.0); }', GLSL 300 is read as 330",
        "'#version 330 core|in vec3 n; out vec4 c;|void main() { c = vec4(n, 1.0); };', GLSL 330 is read as 460",
        "'#version 330 core|in vec3 n; out vec4 c;|void main() { vec3 a[] = { n, n }; c = vec4(a[1], 1.0); }', GLSL 330 is read as 460",
    )
    fun `what drivers take is repaired, on the same line`(text: String, repair: String) {
        val reading = Reading.of("my.frag", text.replace('|', '\n'), Stage.FRAGMENT)
        assertTrue(reading is Reading.Done) { (reading as Reading.Failed).problems.joinToString() }
        reading as Reading.Done
        assertEquals(listOf(repair), reading.repairs)
        assertEquals(3, (0 until reading.shader.size - 1).maxOf(reading.shader::line))
    }

    @Test
    fun `uniforms, inputs and outputs are called as OpenGL calls them`() {
        val shader = shader(
            """
            #version 330 core
            struct Light { vec3 place; float k[2]; };
            uniform Light lights[2];
            uniform Block { mat3 turn; bool on; } block;
            uniform Plain { uint loose; };
            uniform Row { float x; } row[2];
            uniform sampler2D map;
            in Data { vec2 uv; } data;
            flat in int number;
            out vec4 color;
            void main() { color = vec4(lights[1].k[number] + float(loose) + float(block.on) + row[1].x) + texture(map, data.uv) + vec4(block.turn[0], 1.0); }
            """.trimIndent(),
        )
        assertEquals(
            listOf(
                "lights[0].place", "lights[0].k[0]", "lights[0].k[1]", "lights[1].place", "lights[1].k[0]", "lights[1].k[1]",
                "Block.turn", "Block.on", "Row[0].x", "Row[1].x", "loose", "map",
            ).sorted(),
            shader.uniforms.map { it.name }.sorted(),
        )
        assertEquals(setOf("Data.uv", "number"), shader.inputs.map { it.name }.toSet())
        assertEquals(listOf("color"), shader.outputs.map { it.name })
        val kinds = listOf("Block.turn", "Block.on", "loose", "map", "number").associateWith { shader.slot(it)?.kind }
        assertEquals(
            mapOf("Block.turn" to Kind.FLOAT, "Block.on" to Kind.UINT, "loose" to Kind.UINT, "map" to Kind.SAMPLER, "number" to Kind.INT),
            kinds,
        )
    }

    private fun problems(text: String): List<String> =
        (Reading.of("my.frag", text, Stage.FRAGMENT) as Reading.Failed).problems.map { "$it" }
}
