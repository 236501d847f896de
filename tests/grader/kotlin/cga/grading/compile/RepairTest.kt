package cga.grading.compile

import cga.grading.prepared.PreparedSource
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Path

/** Which files are replaced; the compiler is made up. */
class RepairTest {
    private val sources = listOf("Scene.kt", "Game.kt", "Helper.kt", "Main.kt", "Light.kt").mapIndexed { index, name ->
        PreparedSource("game/$name", PreparedSource.place(index, name), hasReference = name != "Helper.kt")
    } + PreparedSource("our window", PreparedSource.place(9, "GameWindow.kt"), isOurs = true)
    private val scene = sources[0]
    private val helper = sources[2]
    private val window = sources.last()
    private val rounds = mutableListOf<Set<PreparedSource>>()
    private var tries = 0

    private fun failing(vararg files: PreparedSource?) =
        CompileResult(null, emptyList(), "a compiler", files.map { CompileError(it, if (it == null) 0 else 1, "wrong") }, emptyList())

    /**
     * Repairs what failed in [first]; the rounds after it fail in [later], one after the other, and then succeed. The compiler itself fails
     * at [breaking].
     */
    private fun repair(first: PreparedSource?, vararg later: PreparedSource, breaking: Set<PreparedSource> = emptySet()): Repair.Repaired? {
        val failures = ArrayDeque(later.toList())

        fun compile(replaced: Set<PreparedSource>): CompileResult {
            rounds += replaced.toSet()
            val next = failures.removeFirstOrNull()
            return next?.let { failing(it) } ?: CompileResult(listOf(Path.of("x")), emptyList(), "a compiler", emptyList(), emptyList())
        }

        fun breaks(sources: List<PreparedSource>) = sources.any(breaking::contains).also { tries++ }
        return Repair(sources, ::compile, ::breaks).repaired(failing(first))
    }

    @Test
    fun `a file with an error is the reference's, all others stay`() {
        assertEquals(listOf(scene), repair(scene)?.files)
        assertEquals(setOf(scene), rounds.single())
    }

    @Test
    fun `who needs a file that was left out is replaced in the next round`() {
        assertEquals(listOf(helper, scene), repair(helper, scene)?.files)
        assertEquals(listOf(setOf(helper), setOf(helper, scene)), rounds)
    }

    @Test
    fun `the one file at which the compiler itself fails is found by halves`() {
        for (source in sources.dropLast(1)) {
            tries = 0
            assertEquals(listOf(source), repair(null, breaking = setOf(source))?.files)
            assertTrue(tries <= 4) { "$tries" }
        }
    }

    @Test
    fun `nothing helps against an error in no file, in our own, or one round after the other`() {
        assertNull(repair(null))
        assertNull(repair(window))
        assertNull(repair(scene, scene))
    }
}
