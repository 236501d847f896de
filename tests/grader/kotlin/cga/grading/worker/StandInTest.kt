package cga.grading.worker

import cga.grading.capture.Moment
import cga.grading.submission.StandIn
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** A game of the course's own kind, compiled with the stand-in by another compiler than ours. */
@Slow
class StandInTest {
    private val game =
        """
        package cga.exercise.game
        import cga.framework.GameWindow
        import org.lwjgl.glfw.GLFW.*

        class Scene(private val window: GameWindow) {
            var last = MOUSE
            fun move(x: Double) {
                println("moved " + (x - last.xpos) + " " + (window.mousePos.xpos - x))
                last = window.mousePos
                window.quit()
            }
        }

        class Game : GameWindow(320, 200, false, true, 3, 3, "Tron", 4, FREQUENCY) {
            private val scene = Scene(this)
            override fun start() {
                val width = IntArray(1)
                glfwGetWindowSize(m_window, width, IntArray(1))
                println("start " + width[0] + " " + windowWidth + " " + framebufferHeight + " " + (m_window != 0L))
                setCursorVisible(false)
                setTitle("Tron")
            }
            override fun update(dt: Float, t: Float) {}
            override fun render(dt: Float, t: Float) {}
            override fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}
            override fun onMouseMove(xpos: Double, ypos: Double) = scene.move(xpos)
            override fun onMouseButton(button: Int, action: Int, mode: Int) {}
            override fun onMouseScroll(xoffset: Double, yoffset: Double) {}
            override fun shutdown() { println("end " + currentTime) }
        }
        """.trimIndent()

    private val main = "import cga.exercise.game.Game\n\nfun main() {\n    Game().run()\n}\n"

    private fun play(
        original: String?,
        mouse: String,
        frequency: String,
    ): List<String> {
        val text = game.replace("MOUSE", mouse).replace("FREQUENCY", frequency)
        val classes = WorkerProcess.compile(mapOf("GameWindow.kt" to StandIn(original).source(), "Game.kt" to text, "Main.kt" to main))
        val run = WorkerProcess.run(listOf(classes), "MainKt")
        assertEquals(0, run.exitCode, "$run")
        return run.out.trim().lines()
    }

    @Test
    fun `a course game runs, with its position of the mouse nested in the window or beside it`() {
        val updates = Math.round(Moment.entries.takeWhile { it.mouse == null }.sumOf { it.seconds } * 120)
        val expected = listOf("start 320 320 200 true", "moved 0.0 0.0", "end ${updates / 120.0}")
        assertEquals(expected, play(null, "GameWindow.MousePosition(640.0, 0.0)", "120.0f"))
        val original = "package cga.framework\n\nclass MousePosition(var xpos: Double, var ypos: Double)\n\nabstract class GameWindow"
        assertEquals(expected, play(original, "cga.framework.MousePosition(640.0, 0.0)", "120"))
    }

    @Test
    fun `a position that is one object begins where the course's own window has it`() {
        val shared = "abstract class GameWindow { val mousePos = MousePosition(0.0, 0.0) }"
        val original = "package cga.framework\n\nclass MousePosition(var xpos: Double, var ypos: Double)\n\n$shared"
        val asked = "cga.framework.MousePosition(window.mousePos.xpos, 0.0)"
        assertTrue("moved 640.0 0.0" in play(original, asked, "120"))
        assertTrue("moved 0.0 0.0" in play(original.replace("MousePosition(0.0, 0.0)", "askedOfGlfw()"), asked, "120"))
    }
}
