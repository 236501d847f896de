package cga.grading.pipeline

import cga.grading.findings.Check
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

/** What a file that does not compile costs. */
class ReplacedFilesTest {
    private val rubric = Rubric.default()

    private fun findings(vararg mistakes: Mistake) =
        Findings(
            Check.entries.map { Measured(it, 0.0, "") },
            mistakes.map { Found(it, 0.0, 1.0, "") },
            emptyList(),
            emptyList(),
            emptyList(),
        )

    private fun lost(findings: Findings) =
        Grade.of(findings, rubric).checks.associate { it.check to it.maximum - (it.points ?: 0.0) }.filterValues { it > 0 }

    @Test
    fun `what belongs to the file earns nothing, the order half, all else stays`() {
        val lost = lost(ReplacedFiles(listOf("src/main/kotlin/cga/exercise/components/light/SpotLight.kt")).applied(findings()))
        val own = listOf(Check.SPOT_LIGHT, Check.SPOT_DIRECTION, Check.ATTENUATION_SPOT).associateWith { rubric.rule(it).points }
        assertEquals(own + (Check.ORDER to rubric.rule(Check.ORDER).points / 2), lost)
    }

    @Test
    fun `a mistake that is the reference's is none of the submission's`() {
        val replaced = ReplacedFiles(listOf("game/Scene.kt")).applied(findings(Mistake.LIGHT_NOT_CHILD, Mistake.PHONG_LEFT))
        assertEquals(listOf(Mistake.KOTLIN_REFUSED, Mistake.PHONG_LEFT), replaced.mistakes.map { it.mistake })
    }

    @Test
    fun `without replaced files nothing changes`() {
        val findings = findings()
        assertSame(findings, ReplacedFiles(emptyList()).applied(findings))
    }
}
