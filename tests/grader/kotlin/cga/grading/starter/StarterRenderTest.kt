package cga.grading.starter

import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.RenderTarget
import cga.grading.corpus.Compiled
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.createDirectory
import kotlin.io.path.readBytes
import kotlin.io.path.writeText

/** The starter compiles by itself, and draws step 4.1 of the solution, to the byte; at every step, for none is solved. */
@ExtendWith(Offscreen::class)
@Slow
class StarterRenderTest {
    @Test
    fun `it draws step 4,1`(
        @TempDir folder: Path,
    ) {
        val starter = folder.resolve("starter")
        StarterExport.write(starter)
        val shot = folder.resolve("shot").createDirectory()
        shot.resolve("Shot.kt").writeText(SHOT)
        val classes = folder.resolve("out")
        assertEquals("", Compiled.complaints(listOf(starter, shot), classes))
        run(starter, classes, folder)
        val expected = solution(Step.EMISSION)
        assertTrue(expected.distinct().size > 50) { "the picture of the solution is empty" }
        for (step in Step.entries) assertArrayEquals(expected, folder.resolve(step.sheet).readBytes(), "step ${step.sheet}")
    }

    /** In a process of its own: its classes have the names of ours. */
    private fun run(
        starter: Path,
        classes: Path,
        target: Path,
    ) {
        val java = Path.of(System.getProperty("java.home"), "bin", "java")
        val log = target.resolve("log").toFile()
        val process =
            ProcessBuilder("$java", "-cp", "$classes:${Compiled.libraries}", "ShotKt", "$target")
                .directory(starter.toFile())
                .redirectErrorStream(true)
                .redirectOutput(log)
                .start()
        if (!process.waitFor(60, SECONDS)) process.destroyForcibly().waitFor()
        assertEquals(0, process.exitValue()) { log.readText() }
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

        /** Draws every step into a file. The mouse moves before, which must not matter yet. */
        val SHOT =
            """
            import cga.exercise.game.ScriptedScene
            import cga.exercise.game.Step
            import cga.framework.RenderTarget
            import cga.framework.context.OffscreenContext
            import java.io.File

            fun main(args: Array<String>) =
                OffscreenContext.open().use {
                    for (step in Step.entries) {
                        val player = ScriptedScene($WIDTH, $HEIGHT, step)
                        player.moveMouseTo(300.0)
                        player.advanceTo($TIME)
                        RenderTarget($WIDTH, $HEIGHT).use { target ->
                            target.bind()
                            player.scene.render()
                            File(args[0], step.sheet).writeBytes(target.read().rgba)
                        }
                    }
                }
            """.trimIndent()
    }
}
