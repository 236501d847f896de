package cga.grading.report

import cga.grading.findings.Check
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class MistakeCardsTest {
    private val height = "The camera rises or sinks when the mouse moves to the side; wanted: it keeps its height."

    private fun grade(vararg texts: Pair<Check, String>): Grade {
        val wrong = texts.toMap()
        val checks = Check.entries.map { Measured(it, if (it in wrong) 1.0 else 0.0, wrong[it].orEmpty()) }
        val found = Found(Mistake.UNKNOWN, 1.0, 1.0, "camera", explains = setOf(Check.ORBIT_FACTOR))
        return Grade.of(Findings(checks, listOf(found), emptyList(), emptyList(), emptyList()), Rubric.default())
    }

    @Test
    fun `what has no name is said by what was measured, in the reader's language`() {
        val grade = grade(Check.ORBIT to height, Check.ORBIT_FACTOR to "The camera turns unevenly.")
        val english = Messages.of(Language.ENGLISH)
        assertEquals(listOf("${english.of(Check.ORBIT).title}: $height"), deviations(grade, english))
        val german = Messages.of(Language.GERMAN)
        val said = "Die Kamera steigt oder sinkt, wenn sich die Maus zur Seite bewegt; verlangt: Sie behält ihre Höhe."
        assertEquals(listOf("${german.of(Check.ORBIT).title}: $said"), deviations(grade, german))
    }

    @Test
    fun `nothing is said twice, and not all of a long list`() {
        assertEquals(emptyList<String>(), deviations(grade(Check.SPECULAR to "unknown pointLight.color"), Messages.of(Language.ENGLISH)))
        val all = grade(*Check.entries.map { it to height }.toTypedArray())
        assertEquals(5, deviations(all, Messages.of(Language.ENGLISH)).size)
    }
}
