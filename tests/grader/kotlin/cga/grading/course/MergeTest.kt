package cga.grading.course

import cga.framework.InputError
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.writeText

@Slow
class MergeTest {
    @TempDir
    lateinit var folder: Path

    private val all = Array(8) { "s$it" to if (it == 3) "phong" else "right" }

    private fun shard(index: Int, count: Int = 2): Path {
        val submissions = FakeGrader.submissions(folder.resolve("in"), *all)
        val shard = Shard(index, count)
        return folder.resolve("part$index").also { FakeGrader.run(it, submissions.filter { s -> s in shard }, FakeGrader(), shard = shard) }
    }

    private fun merge(vararg parts: Path): Merged {
        val out = folder.resolve("all${parts.size}")
        return ResultStore.open(out, resume = false).use { store ->
            Merge(store, FakeGrader.settings, FakeGrader.Silent).run(parts.toList()).also {
                CourseReport.write(out, it.submissions, it.missing, FakeGrader.settings.language)
            }
        }
    }

    @Test
    fun `the shards together are the whole course`() {
        val merged = merge(shard(1), shard(2))
        assertEquals(all.map { it.first }, merged.submissions.map { it.name }.sorted())
        assertEquals(listOf(92.0), merged.submissions.mapNotNull { it.points }.filter { it < 100 })
        assertEquals(emptyList<String>(), merged.warnings + merged.missing)
        assertEquals(9, folder.resolve("all2/grades.csv").readLines().size)
        assertTrue(folder.resolve("all2/s3/report.html").exists())
    }

    @Test
    fun `a shard or a result that is not there is told`() {
        val first = shard(1)
        val name = Manifest.read(first).entries.first()
        first.resolve("${name.folder}/outcome.json").deleteExisting()
        val merged = merge(first)
        assertEquals(listOf(name.name), merged.missing)
        assertTrue(merged.warnings.any { "shards" in it && ": 2;" in it }) { "${merged.warnings}" }
        assertTrue(merged.warnings.any { name.name in it })
    }

    @Test
    fun `the same result twice is one, another one of the same name is kept beside it`() {
        val first = shard(1)
        val again = folder.resolve("part1b")
        first.toFile().copyRecursively(again.toFile())
        assertEquals(emptyList<String>(), merge(first, again).warnings.filter { "twice" in it })
        val entry = Manifest.read(first).entries.first()
        folder.resolve("in/${entry.name}/what").writeText("loops")
        val changed = folder.resolve("part1c")
        val submission = Submission.of(listOf(folder.resolve("in/${entry.name}")))
        FakeGrader.run(changed, submission, FakeGrader())
        val merged = merge(first, again, changed)
        assertEquals(2, merged.submissions.count { it.name == entry.name })
        assertTrue(merged.warnings.any { "twice" in it && entry.name in it })
    }

    @Test
    fun `what holds no results is refused`() {
        assertThrows<InputError> { merge(folder) }
        val part = shard(1)
        part.resolve("course.json").writeText("{\"shard\": \"1/1\", \"submissions\": [{\"name\": \"a\", \"folder\": \"../a\"}]}")
        assertThrows<InputError> { merge(part, part) }
    }
}
