package cga.grading.analysis

import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class UniformDeclarationsTest {
    private val source =
        """
        #version 330 core
        // uniform vec3 commented;
        struct Inner { vec3 color, other; };
        struct Light {
            highp vec3 pos; // where it is
            Inner inner[2];
        };
        uniform Light lights[4];
        uniform struct Own { float size; } own;
        uniform highp vec3 tint, spare = vec3(1.0);
        vec3 shade(vec3 direction) { return direction; }
        void main() { vec3 pos = lights[0].pos; }
        """.trimIndent()

    private val declarations = UniformDeclarations(listOf(source), setOf("lights[0].pos", "lights[1].pos"))

    @Test
    fun `plain uniforms and members of structs are declared`() {
        for (name in listOf("tint", "spare", "lights[3].inner[1].other", "lights[0].inner[0].color", "own.size")) {
            assertTrue(declarations.declares(name)) { name }
        }
    }

    @Test
    fun `what is a word of the shader and no uniform is not`() {
        for (name in listOf("direction", "lights[0].direction", "lights[0].color", "commented", "pos", "Light", "own.pos", "main", "")) {
            assertFalse(declarations.declares(name)) { name }
        }
    }

    @Test
    fun `an index beyond those in use is not`(): Unit = assertFalse(declarations.declares("lights[4].pos"))
}
