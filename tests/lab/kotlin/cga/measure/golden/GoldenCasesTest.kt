package cga.measure.golden

import cga.exercise.game.Step
import cga.framework.SpecularModel
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What the list of goldens has to cover, and how large it may become. */
class GoldenCasesTest {
    private val all = GoldenCases.all
    private val folder = projectRoot.resolve(GoldenRun.FOLDER)

    @Test
    fun `names are unique and fit for files, and no two cases are the same`() {
        assertEquals(all.size, all.map { it.name }.toSet().size)
        for (case in all) assertTrue(case.name.matches(Regex("[a-z0-9.-]+")) && case.shows.isNotBlank(), case.name)
        assertEquals(all.size, all.map { it.made() }.toSet().size)
    }

    @Test
    fun `every step, every switch, and time, drive and orbit are covered`() {
        assertEquals(Step.entries.toSet(), all.map { it.step }.toSet())
        assertTrue(all.any { it.specular == SpecularModel.PHONG && it.step == Step.BLINN_PHONG })
        assertTrue(all.any { it.specular == SpecularModel.BLINN_PHONG && it.step.specularModel == SpecularModel.PHONG })
        for (covers in listOf<(GoldenCase) -> Boolean>({ it.gamma != 1f }, { it.samples == 4 }, { it.float })) assertTrue(all.any(covers))
        assertTrue(all.count { it.mouse != 0.0 } >= 5 && all.count { it.drive.isNotEmpty() } >= 5)
        assertTrue(all.map { it.t }.toSet().size >= 8)
        assertTrue(all.none { it.mouse != 0.0 && !it.step.turnsWithMouse }, "a mouse without effect")
    }

    @Test
    fun `there are at most 40 images and 10 MB`() {
        val files = folder.listFiles().orEmpty()
        val images = files.filter { it.extension != "json" }
        assertTrue(images.size in all.size..40, "${images.size} images")
        val bytes = files.sumOf { it.length() }
        assertTrue(bytes <= 10_000_000, "$bytes bytes")
    }
}
