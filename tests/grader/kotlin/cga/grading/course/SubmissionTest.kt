package cga.grading.course

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import java.nio.file.Path

class SubmissionTest {
    @Test
    fun `names become plain files`() {
        val names =
            mapOf(
                "Jörg Müßig" to "Jorg_Mussig",
                "../../etc/passwd" to "etc_passwd",
                "<img src=x>" to "img_src_x",
                ".hidden" to "hidden",
                "日本" to "submission",
                "" to "submission",
                ".." to "submission",
                "-rf" to "rf",
                "index.html" to "index.html_",
                "CON" to "CON_",
                "a".repeat(300) to "a".repeat(60),
                "a\u0000\nb" to "a_b",
            )
        for ((name, plain) in names) assertEquals(plain, Submission.plain(name), name)
    }

    @Test
    fun `no two share a folder, whatever the order and the file system`() {
        val paths = listOf("x/anna", "y/anna", "x/Anna.zip", "x/änna", "x/bo.tar.gz", "x/bo2").map(Path::of)
        val submissions = Submission.of(paths)
        assertEquals(submissions.size, submissions.map { it.folder.lowercase() }.distinct().size)
        assertEquals(listOf("x/anna", "y/anna", "Anna", "änna", "bo", "bo2"), submissions.map { it.name })
        val again = Submission.of(paths.reversed()).associate { it.path to it.folder }
        for (submission in submissions) assertEquals(submission.folder, again[submission.path])
    }

    @Test
    fun `the same folder named twice is one submission`() {
        assertEquals(1, Submission.of(listOf(Path.of("x/anna"), Path.of("x/./anna/"), Path.of("y/../x/anna"))).size)
    }

    @Test
    fun `every submission is in exactly one shard, whichever others there are`() {
        val all = Submission.of((1..400).map { Path.of("x/student$it") })
        val shards = (1..4).map { Shard(it, 4) }
        for (submission in all) assertEquals(1, shards.count { submission in it })
        val few = Submission.of(listOf(Path.of("x/student7"))).single()
        assertEquals(shards.find { all[6] in it }?.index, shards.find { few in it }?.index)
        // A binomial share of 100 has a standard deviation of 8.7.
        for (shard in shards) assertTrue(all.count { it in shard } in 65..135)
        assertTrue(all.all { it in Shard.WHOLE })
    }

    @Test
    fun `a shard is read or refused with the cure`() {
        assertEquals("2/4", "${Shard.of("2/4")}")
        for (text in listOf("0/4", "5/4", "2", "a/b", "1/0", "2/4/", "-1/2", "99999999999/2")) {
            assertTrue("2/4" in assertThrows<InputError> { Shard.of(text) }.message.orEmpty())
        }
        assertNotEquals(Shard.of("1/2").index, Shard.of("2/2").index)
    }
}
