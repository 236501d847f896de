package cga.grading.compile

import cga.grading.submission.MadeUp
import cga.grading.submission.SourceFile
import cga.grading.submission.SubmissionReader
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** Which files are replaced; the compiler is made up. */
class RepairTest {
    @TempDir
    lateinit var folder: Path

    private val scene = "src/main/kotlin/cga/exercise/game/Scene.kt"
    private val game = "src/main/kotlin/cga/exercise/game/Game.kt"
    private val helper = "src/main/kotlin/cga/exercise/game/Helper.kt"
    private val submission by lazy {
        SubmissionReader.read(
            MadeUp.write(folder, MadeUp.FILES + (helper to "package cga.exercise.game\nclass Helper\n")),
            folder.resolve("unused"),
        )
    }
    private val rounds = mutableListOf<Map<String, String>>()

    private fun failing(vararg files: String?) =
        CompileResult(null, emptyList(), "a compiler", files.map { CompileError(it, 1, "wrong") }, emptyList())

    /** Repairs what failed in [first]; the rounds after it fail in [later], one after the other, and then succeed. */
    private fun repair(first: String?, vararg later: String): Repair.Repaired? {
        val failures = ArrayDeque(later.toList())

        fun compile(sources: List<SourceFile>): CompileResult {
            rounds += sources.associate { it.name to it.text }
            val next = failures.removeFirstOrNull()
            return next?.let { failing(it) } ?: CompileResult(folder, emptyList(), "a compiler", emptyList(), emptyList())
        }
        return Repair(submission, ::compile).repaired(failing(first))
    }

    @Test
    fun `a file with an error is the reference's, all others stay`() {
        val repaired = repair(scene)
        assertEquals(listOf(scene), repaired?.files)
        assertTrue("class Scene(private val window: GameWindow)" in rounds.single().getValue(scene))
        assertEquals(MadeUp.GAME, rounds.single()[game])
    }

    @Test
    fun `a file that the reference has not is left out, and who needs it is replaced in the next round`() {
        val repaired = repair(helper, scene)
        assertEquals(listOf(helper, scene), repaired?.files)
        assertEquals(listOf(helper), repaired?.leftOut)
        assertTrue(rounds.none { helper in it })
        assertEquals(MadeUp.SCENE, rounds.first()[scene])
    }

    @Test
    fun `nothing helps against an error in no file, in the reference's own, or one round after the other`() {
        assertNull(repair(null))
        assertNull(repair("GameWindow.kt (our stand-in)"))
        assertNull(repair(scene, scene))
    }
}
