package cga.grading.corpus

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class SaidAlreadyTest {
    @Test
    fun `what was said is known to the next run, of the same capture only`(
        @TempDir folder: Path,
    ) {
        val said = Judgement("plain", Answer.FALSE_ALARM, 99.5, setOf("4.2.light", "4.7.halfvector"), 100.0, false)
        SaidAlready(folder).note(folder.resolve("plain~01.capture"), said)
        assertEquals(said, SaidAlready(folder).of(Path.of("elsewhere/plain~01.capture")))
        assertNull(SaidAlready(folder).of(folder.resolve("plain~02.capture")))
    }
}
