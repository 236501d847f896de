package cga.measure.mutation

import cga.framework.Home
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class MutantsTest {
    @Test
    fun `every mutant that edits files changes each of them`() {
        for (mutant in Mutants.ALL.filter { it.edits.isNotEmpty() }) {
            val files = mutant.edits.map { it.file }
            val sound = files.map { Home.read(it, "input") }
            val spoilt = MutatedHome.use(mutant.edits) { files.map { Home.read(it, "input") } }
            for (i in files.indices) assertTrue(!sound[i].contentEquals(spoilt[i]), "${mutant.name} leaves ${files[i]} as it was")
        }
    }

    @Test
    fun `the files are as before when a mutant is done with`() {
        val shader = "shaders/scene.frag"
        val before = Home.read(shader, "shader")
        val edit = TextEdit(shader, "void main() {", "void main() { // spoilt")
        assertNotEquals(String(before), MutatedHome.use(listOf(edit)) { String(Home.read(shader, "shader")) })
        assertArrayEquals(before, Home.read(shader, "shader"))
    }

    @Test
    fun `a mutant that no longer fits the shader is refused`() {
        for ((text, times) in listOf("no such text" to 0, "vec3" to 42)) {
            val edit = TextEdit("shaders/scene.frag", text, "")
            val error = assertThrows(IllegalStateException::class.java) { MutatedHome.use(listOf(edit)) { error("reached") } }
            assertTrue(error.message.orEmpty().startsWith("shaders/scene.frag holds "), "$times times: ${error.message}")
        }
    }

    @Test
    fun `names are unique, and the table has a row for each`() {
        val names = Mutants.ALL.map { it.name }
        assertEquals(names.distinct(), names)
        val rows = projectRoot.resolve("docs/golden.md").readLines().filter { it.startsWith("| ") }.map { it.split(" | ").first().drop(2) }
        assertEquals(emptyList<String>(), names - rows.toSet(), "not in docs/golden.md: ./cga golden mutants --doc docs/golden.md")
    }

    @Test
    fun `noise takes each of its three values about as often`() {
        val counts = List(30_000) { (3 * noise(it)).toInt() }.groupingBy { it }.eachCount()
        assertEquals(setOf(0, 1, 2), counts.keys)
        // 10 000 expected, standard deviation √(n·1/3·2/3) ≈ 82; five of them.
        assertTrue(counts.values.all { it in 9_590..10_410 }, "$counts")
    }
}
