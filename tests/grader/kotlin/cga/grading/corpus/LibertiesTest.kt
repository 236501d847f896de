package cga.grading.corpus

import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** Programs that run on some machines of students and not as they are on the grader's, from their sources to their points. */
@ExtendWith(Offscreen::class)
@Slow
class LibertiesTest {
    @TestFactory
    fun `what a person could run is graded`(
        @TempDir folder: Path,
    ) = CorpusCaptures(folder).let { captures ->
        POINTS.map { (name, points) ->
            dynamicTest(name) {
                val submission = Corpus.byName(name)
                val answered = Answered.of(submission, captures.of(submission))
                assertEquals(points, answered.points, answered.details.joinToString("\n"))
                assertEquals(submission.expectation.mistakes.flatten(), answered.named)
            }
        }
    }

    private companion object {
        const val ALL = 100.0
        const val LESS = 99.0
        val POINTS =
            mapOf(
                "student-cursor-recentred-when-moved" to ALL,
                "student-cursor-recentred-in-update" to ALL,
                "glsl-only-some-drivers-unwritten" to LESS,
            )
    }
}
