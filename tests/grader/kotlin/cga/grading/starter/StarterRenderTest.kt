package cga.grading.starter

import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.RenderTarget
import cga.grading.corpus.Compiled
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.createDirectory
import kotlin.io.path.deleteExisting
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import kotlin.math.pow

/** The starter and the solution that it was cut from compile by themselves, and draw what steps 4.1 and 4.7 of ours draw. */
@ExtendWith(Offscreen::class)
@Slow
class StarterRenderTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `the starter draws step 4,1`() {
        val starter = folder.resolve("starter")
        StarterExport.write(starter)
        assertEquals(Step.EMISSION, nearest(draw(starter)))
    }

    @Test
    fun `filled in it draws step 4,7`() {
        val starter = folder.resolve("starter")
        StarterExport.write(starter)
        val templates = StarterFiles(StarterLanguage.ENGLISH).templates()
        for ((path, template) in templates) starter.resolve(path).writeText(Template.solution(template.starter, template.regions))
        assertEquals(Step.BLINN_PHONG, nearest(draw(starter)))
    }

    /** The step of ours whose picture differs least: the starter lets the driver make the mip levels, so none is the same to the byte. */
    private fun nearest(picture: ByteArray): Step {
        assertTrue(picture.distinct().size > 50) { "the picture is empty" }
        return Step.entries.minBy { step ->
            val expected = solution(step)
            picture.indices.sumOf { (picture[it].toUByte().toDouble() - expected[it].toUByte().toDouble()).pow(2) }
        }
    }

    /** Drawn by the program in [starter], in a process of its own: its classes have the names of ours. */
    private fun draw(starter: Path): ByteArray {
        val shot = folder.resolve("shot").createDirectory()
        shot.resolve("Shot.kt").writeText(SHOT)
        // Their window needs a display.
        starter.resolve("src/main/kotlin/cga/framework/GameWindow.kt").writeText(WINDOW)
        starter.resolve("src/main/kotlin/cga/exercise/game/Game.kt").deleteExisting()
        starter.resolve("src/main/kotlin/cga/exercise/Main.kt").deleteExisting()
        val classes = folder.resolve("out")
        assertEquals("", Compiled.complaints(listOf(starter, shot), classes))
        val java = Path.of(System.getProperty("java.home"), "bin", "java")
        val log = folder.resolve("log").toFile()
        val process =
            ProcessBuilder("$java", "-cp", "$classes:${Compiled.libraries}", "ShotKt", "${folder.resolve("picture")}")
                .directory(starter.toFile())
                .redirectErrorStream(true)
                .redirectOutput(log)
                .start()
        if (!process.waitFor(60, SECONDS)) process.destroyForcibly().waitFor()
        assertEquals(0, process.exitValue()) { log.readText() }
        return folder.resolve("picture").readBytes()
    }

    private fun solution(step: Step): ByteArray {
        val player = ScriptedScene(WIDTH, HEIGHT, step).apply { advanceTo(TIME) }
        return RenderTarget(WIDTH, HEIGHT).use { target ->
            target.bind()
            player.scene.render()
            target.read().rgba.also { player.scene.cleanup() }
        }
    }

    private companion object {
        const val WIDTH = 480
        const val HEIGHT = 270
        const val TIME = 5.3

        const val WINDOW =
            """
            package cga.framework

            class GameWindow {
                fun getKeyState(key: Int) = false
            }
            """

        /** Draws a picture into a file, its rows from top to bottom. */
        val SHOT =
            """
            import cga.exercise.game.Scene
            import cga.framework.GameWindow
            import org.lwjgl.glfw.GLFW.*
            import org.lwjgl.opengl.GL
            import org.lwjgl.opengl.GL33C.*
            import org.lwjgl.system.Configuration
            import org.lwjgl.system.FunctionProvider
            import org.lwjgl.system.MemoryUtil
            import java.io.File

            fun main(args: Array<String>) {
                Configuration.OPENGL_EXPLICIT_INIT.set(true)
                glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_NULL)
                check(glfwInit())
                glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3)
                glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3)
                glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE)
                val window = listOf(GLFW_OSMESA_CONTEXT_API, GLFW_EGL_CONTEXT_API).firstNotNullOf { api ->
                    glfwWindowHint(GLFW_CONTEXT_CREATION_API, api)
                    glfwCreateWindow($WIDTH, $HEIGHT, "", 0, 0).takeIf { it != 0L }
                }
                glfwMakeContextCurrent(window)
                GL.create(FunctionProvider { glfwGetProcAddress(it) })
                GL.createCapabilities()
                val scene = Scene(GameWindow())
                glViewport(0, 0, $WIDTH, $HEIGHT)
                scene.update(1f / 120, ${TIME}f)
                scene.render(1f / 60, ${TIME}f)
                val pixels = MemoryUtil.memAlloc(4 * $WIDTH * $HEIGHT)
                glReadPixels(0, 0, $WIDTH, $HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, pixels)
                val rgba = ByteArray(pixels.capacity())
                for (row in 0 until $HEIGHT) pixels.get(4 * $WIDTH * ($HEIGHT - 1 - row), rgba, 4 * $WIDTH * row, 4 * $WIDTH)
                File(args[0]).writeBytes(rgba)
            }
            """.trimIndent()
    }
}
