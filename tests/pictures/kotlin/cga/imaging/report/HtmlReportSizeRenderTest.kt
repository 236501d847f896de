package cga.imaging.report

import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.RenderTarget
import cga.imaging.BytePicture
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.random.Random

/** The promise to whoever mails a report: 40 cases of renders, all of which differ, stay below 10 MB. */
@ExtendWith(Offscreen::class)
@Slow
class HtmlReportSizeRenderTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `a report of 40 renders that differ everywhere stays below 10 MB`() {
        val renders = Step.entries.map(::render)
        // Noise is the worst that there is: every pixel costs bytes in the pictures and in the error map.
        val cases = List(40) { i -> renders[i % renders.size].let { caseOf(it, it.noisy(2, Random(i)), "case $i") } }
        assertTrue(cases.all { it.comparison!!.difference.fraction > 0.9 })
        val file = folder.resolve("report.html")
        HtmlReport.write("40 cases", cases, file)
        assertTrue(Files.size(file) < 10_000_000) { "${Files.size(file)} bytes" }
    }

    private fun render(step: Step): BytePicture {
        val player = ScriptedScene(480, 270, step)
        return RenderTarget(480, 270).use { target ->
            player.advanceTo(5.3)
            target.bind()
            player.scene.render()
            BytePicture.opaque(target.read()).also { player.scene.cleanup() }
        }
    }
}
