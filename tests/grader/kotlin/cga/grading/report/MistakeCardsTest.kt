package cga.grading.report

import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Graded
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.pipeline.ReplacedFiles
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

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

    /** Its file of the point light is the reference's. */
    private fun repaired(pictures: List<Evidence> = emptyList()): Findings {
        val checks = Check.entries.map { Measured(it, 0.0, "") }
        return ReplacedFiles(listOf("PointLight.kt")).applied(Findings(checks, emptyList(), emptyList(), pictures, emptyList()))
    }

    @Test
    fun `a file that does not compile costs what belongs to it, and a shader leaves open what cannot be seen`() {
        val english = Messages.of(Language.ENGLISH)
        val file = Grade.of(repaired(), Rubric.default())
        val order = file.checks.single { it.check == Check.ORDER }
        val expected = "−1 · ${english.of(Check.ORDER).title}; −12 · what belongs to the file"
        assertEquals(expected, cost(Mistake.KOTLIN_REFUSED, order, file, english))
        assertEquals(Rubric.default().total - 13, file.points, 1e-9)
        val hidden = Check.entries.map { Measured(it, if (it == Check.DIFFUSE) null else 0.0, "") }
        val refused = Found(Mistake.SHADER_REFUSED, 0.0, 1.0, "fragment shader")
        val shader = Grade.of(Findings(hidden, listOf(refused), emptyList(), emptyList(), emptyList()), Rubric.default())
        assertEquals("4 open", cost(Mistake.SHADER_REFUSED, null, shader, english))
        assertNull(cost(Mistake.PHONG_LEFT, null, shader, english))
    }

    @Test
    fun `a picture that the reference's files drew is nobody's own`(
        @TempDir folder: Path,
    ) {
        val english = Messages.of(Language.ENGLISH)
        val perfect = (Fakes.perfect(folder) as Graded).findings
        val own = EvidencePictures(folder, perfect, english).main.single()
        assertEquals(english.text("page.yours"), own.own)
        val repaired = repaired(perfect.pictures)
        assertEquals(english.text("page.repaired"), EvidencePictures(folder, repaired, english).main.single().own)
        Thumbnail.write(perfect, folder)
        assertNotNull(Thumbnail.url(folder))
        Thumbnail.write(repaired, folder)
        assertNull(Thumbnail.url(folder))
    }
}
