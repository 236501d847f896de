package cga.measure.start

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.readText

class InterleavedTest {
    @Test
    fun `each command runs once a round, and every second round in the opposite order`(
        @TempDir folder: Path,
    ) {
        val log = folder.resolve("log")
        val commands = listOf("a", "b", "c").associateWith { listOf("sh", "-c", "printf \"\${NAME}$it,\" >>'$log'") }
        val times = Interleaved.time(commands, 3, mapOf("NAME" to "run "))
        assertEquals("run a,run b,run c," + "run c,run b,run a," + "run a,run b,run c," + "run c,run b,run a,", log.readText())
        assertEquals(commands.keys, times.keys)
        assertTrue(times.values.all { it.seconds.lowest > 0 && it.processorSeconds.lowest >= 0 })
    }

    @Test
    fun `a command that fails is no measurement`() {
        val error = assertThrows<InputError> { Interleaved.time(mapOf("bad" to listOf("sh", "-c", "exit 3")), 1) }
        assertTrue("exit code 3" in error.message.orEmpty()) { "${error.message}" }
    }

    @Test
    fun `processor time is what the children took, user and system`() {
        assertEquals(60 + 0.25 + 0.5, Interleaved.processorSeconds("0m9.0s 0m9.0s\n1m0.250000s 0m0.500000s\n"), 1e-9)
    }
}
