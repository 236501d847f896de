package cga.grading.rubric

import cga.framework.InputError
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.writeText

class RubricTest {
    @TempDir
    lateinit var folder: Path

    private val text = Rubric.defaultBytes().decodeToString()

    private fun read(text: String): Rubric = Rubric.read(folder.resolve("mine.json").apply { writeText(text) })

    private fun assertRefused(text: String, vararg words: String) {
        val message = assertThrows<InputError> { read(text) }.message.orEmpty()
        for (word in words.toList() + "mine.json") assertTrue(word in message) { "$word is not in: $message" }
    }

    @Test
    fun `the default gives 100 points, some for every check`() {
        val rubric = Rubric.default()
        assertEquals(100.0, rubric.total)
        assertTrue(Check.entries.all { rubric.rule(it).points > 0 })
        assertEquals(
            listOf(30.0, 32.0, 12.0, 10.0, 8.0, 8.0),
            Check.entries.groupBy { it.task }.map { (_, checks) ->
                checks.sumOf { rubric.rule(it).points }
            },
        )
    }

    @Test
    fun `a rubric of one's own replaces it`() {
        val rubric = read(text.replace("\"4.7.halfvector\": {\"points\": 8", "\"4.7.halfvector\": {\"points\": 20.5"))
        assertEquals(112.5, rubric.total)
        assertEquals(0.5, rubric.cost(Mistake.ATTENUATION_OTHER_K))
        assertEquals(1.0, rubric.cost(Mistake.CONE_INSIDE_OUT))
    }

    @Test
    fun `points fall in a straight line between tolerance and zero`() {
        val rule = CheckRule(4.0, tolerance = 0.02, zero = 0.12)
        assertEquals(listOf(1.0, 1.0, 0.5, 0.0, 0.0), listOf(0.0, 0.02, 0.07, 0.12, 9.0).map { Math.round(rule.share(it) * 1e9) / 1e9 })
        assertEquals(0.0, CheckRule(4.0, 0.02, 0.02).share(0.0200001))
    }

    @Test
    fun `a mistake in the file is told with the key and the cure`() {
        assertRefused(text.replace("\"4.2.light\"", "\"4.2.lihgt\""), "4.2.lihgt")
        assertRefused(text.replace(Regex("    \"4\\.7\\.halfvector.*\\n"), "").replace("distance\"},\n  },", "distance\"}\n  },"), "")
        assertRefused(text.replace("\"points\": 8", "\"points\": -1"), "4.7.halfvector.points", "-1", "0 to")
        assertRefused(text.replace("\"points\": 8", "\"points\": \"NaN\""), "4.7.halfvector.points")
        assertRefused(text.replace("\"tolerance\": 0.25", "\"tolerance\": 2"), "4.6.lights", "zero", "tolerance")
        assertRefused(text.replace("\"attenuation-other-k\": 0.5", "\"attenuation-other-k\": 1.5"), "attenuation-other-k")
        assertRefused(text.replace(Regex("\"points\": \\d"), "\"points\": 0"), "0 points")
        assertRefused("{\"name\": \"x\", \"checks\": {\"4.2.light\": {\"points\": 1, \"tolerance\": 0.1}}}", "4.2.child", "missing")
        assertRefused("points: 5", "JSON")
    }
}
