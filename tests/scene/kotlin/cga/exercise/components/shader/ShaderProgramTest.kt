package cga.exercise.components.shader

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

class ShaderProgramTest {
    @Test
    fun `it is made and thrown away without OpenGL`() {
        ShaderProgram("shaders/scene.vert", "shaders/scene.frag").cleanup()
    }

    @Test
    fun `a missing file is named at once`() {
        for ((vertex, fragment) in listOf("shaders/missing" to "shaders/scene.frag", "shaders/scene.vert" to "shaders/missing")) {
            val error = assertThrows<InputError> { ShaderProgram(vertex, fragment) }
            assertTrue("shaders" in error.message.orEmpty() && "missing" in error.message.orEmpty()) { error.message }
        }
    }
}
