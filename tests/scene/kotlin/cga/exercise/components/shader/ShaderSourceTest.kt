package cga.exercise.components.shader

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createParentDirectories
import kotlin.io.path.writeText

class ShaderSourceTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `an included file stands in the place of its line`() {
        write("a.frag", "#version 330 core\n#include \"b.glsl\"\nend\n")
        write("b.glsl", "one\r\ntwo\r\n")
        assertEquals("#version 330 core\none\ntwo\nend\n", ShaderSource.read("$folder/a.frag").text)
    }

    @Test
    fun `a file is included once, and a circle ends`() {
        write("a.frag", "#include \"b.glsl\"\n#include \"c.glsl\"\nend")
        write("b.glsl", "b\n#include \"c.glsl\"\n")
        write("c.glsl", "c\n#include \"b.glsl\"\n#include \"a.frag\"\n")
        assertEquals("b\nc\nend", ShaderSource.read("$folder/a.frag").text)
    }

    @Test
    fun `files are found from the one that includes them`() {
        write("inner/a.frag", "#include \"../b.glsl\"")
        write("b.glsl", "#include \"inner/c.glsl\"")
        write("inner/c.glsl", "c")
        assertEquals("c", ShaderSource.read("$folder/inner/a.frag").text)
    }

    @Test
    fun `a message about a line names the file that it is in`() {
        write("a.frag", "first\n#include \"b.glsl\"\nlast\n")
        write("b.glsl", "one\n  two\n")
        val source = ShaderSource.read("$folder/a.frag")
        val expected =
            listOf(
                "$folder/a.frag:1: error: x\n    first",
                "$folder/b.glsl:2: error: x\n    two",
                "$folder/a.frag:3: error: x\n    last",
            )
        assertEquals(expected, listOf(1, 3, 4).map { ShaderCompiler.explain(source, "0:$it(7): error: x") })
    }

    @Test
    fun `a file that is not there is named with the line that includes it`() {
        write("a.frag", "first\n#include \"b.glsl\"\n")
        val message = assertThrows<InputError> { ShaderSource.read("$folder/a.frag") }.message.orEmpty()
        assertTrue(message.startsWith("$folder/a.frag:2 includes b.glsl: ") && "does not exist" in message, message)
    }

    @Test
    fun `constants are replaced in included files too`() {
        write("a.frag", "#include \"b.glsl\"\nconst int MORE = 5;")
        write("b.glsl", "const int LIGHTS = 10;")
        assertEquals("const int LIGHTS = 3;\nconst int MORE = 5;", ShaderSource.read("$folder/a.frag", mapOf("LIGHTS" to 3)).text)
    }

    private fun write(name: String, text: String) = folder.resolve(name).createParentDirectories().writeText(text)
}
