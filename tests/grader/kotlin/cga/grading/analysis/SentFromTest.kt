package cga.grading.analysis

import cga.grading.capture.SampleCapture
import cga.grading.capture.UniformValue
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.GL_FLOAT

class SentFromTest {
    private val chains =
        listOf(
            listOf("shader/Program.kt:20", "light/PointLight.kt:8", "game/Scene.kt:70"),
            listOf("shader/Program.kt:31", "light/PointLight.kt:9", "game/Scene.kt:70"),
            listOf("shader/Program.kt:20", "game/Scene.kt:75"),
            listOf("game/Scene.kt:80"),
        )
    private val uniforms = listOf("position", "color", "ambient", "raw", "unset").mapIndexed { i, name ->
        UniformValue(name, GL_FLOAT, floatArrayOf(0f), if (i < chains.size) i else -1)
    }
    private val sent = SentFrom(SampleCapture.capture(listOf(SampleCapture.draw(uniforms = uniforms)), callers = chains))

    private fun places(uniform: String) = sent.places(uniform).map { "$it" }

    @Test
    fun `the line that names the uniform comes before those that called it, and the class for programs is left out`() {
        assertEquals(listOf("light/PointLight.kt:8", "game/Scene.kt:70"), places("position"))
        assertEquals(listOf("light/PointLight.kt:9", "game/Scene.kt:70"), places("color"))
        assertEquals(listOf("game/Scene.kt:75"), places("ambient"))
    }

    @Test
    fun `what is sent to OpenGL straight from the scene is told from there, and what was never sent from nowhere`() {
        assertEquals(listOf("game/Scene.kt:80"), places("raw"))
        assertEquals(emptyList<String>(), places("unset"))
        assertEquals(emptyList<String>(), places("no such"))
    }
}
