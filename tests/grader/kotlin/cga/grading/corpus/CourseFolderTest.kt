package cga.grading.corpus

import cga.grading.findings.FailureReason
import cga.grading.findings.Mistake
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.io.path.createTempDirectory
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readLines

class CourseFolderTest {
    private val course = CourseFolder.members(200)

    @Test
    fun `a tenth is broken, the rest half correct and half mistaken, all under names of their own`() {
        assertEquals(mapOf("correct" to 100, "mistaken" to 80, "broken" to 20), course.groupingBy { it.kind }.eachCount())
        assertEquals(200, course.map { it.name }.distinct().size)
        assertEquals(20, course.filter { it.kind == "broken" }.map { it.name.drop(4) }.distinct().size)
    }

    @Test
    fun `what is wanted are mistakes and reasons that there are`() {
        val mistakes = Mistake.entries.map { it.id }
        val reasons = FailureReason.entries.map { it.id } + "graded"
        for (member in course) {
            val words = member.wanted.split(' ', '|').filter(String::isNotEmpty)
            assertTrue((if (member.kind == "broken") reasons else mistakes).containsAll(words)) { "${member.name}: ${member.wanted}" }
            assertEquals(member.kind == "correct", words.isEmpty(), member.name)
        }
    }

    @Test
    fun `the folder holds each submission, and what is expected of it`() {
        val folder = createTempDirectory("course")
        try {
            CourseFolder.write(folder, 10)
            val written = folder.listDirectoryEntries().filter { it.isDirectory() }.map { it.name }.sorted()
            val expected = folder.resolve(CourseFolder.EXPECTED).readLines().drop(1).map { it.substringBefore(',') }
            assertEquals(written, expected)
            assertEquals(CourseFolder.members(10).map { it.name }, expected)
        } finally {
            folder.toFile().deleteRecursively()
        }
    }
}
