package cga.grading.pipeline

import cga.grading.findings.FailureReason
import cga.grading.prepared.Edition
import cga.grading.sandbox.End
import cga.grading.sandbox.Limit
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.Sandbox
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/** What is told of the ways in which measuring can end, the process itself being made up. */
@Slow
class MeasureStepTest {
    @TempDir
    lateinit var folder: Path

    // Where other tests have it too: making its archive of classes takes seconds.
    private val programs = Programs(Path.of("build/compilers").toAbsolutePath())
    private val tries = ArrayList<Path>()

    private fun stopped(end: End, errors: String = "", next: End = end): Stopped {
        val scratch = folder.resolve("scratch").createDirectories()
        val sandbox = Sandbox { job ->
            tries.add(job.scratch)
            // What a submission might have left there is not read before the process has ended well.
            job.scratch.resolve("findings.json").writeText("{}")
            Outcome(if (tries.size == 1) end else next, "", errors, 1.0, 1.0, 1)
        }
        val step = MeasureStep(sandbox, programs, Limits())
        return assertThrows { step.measure(Edition.ALL.first(), folder.resolve("capture.bin"), scratch, folder, Run()) }
    }

    @Test
    fun `a shader that takes too long or brings the driver down is told as the shader's`() {
        val late = stopped(End.Exceeded(Limit.WALL_CLOCK))
        assertEquals(FailureReason.TIMED_OUT, late.reason)
        val crash = stopped(End.Signalled(11))
        assertEquals(FailureReason.CRASHED, crash.reason)
        assertTrue("shaders" in late.detail && "shaders" in crash.detail) { "${late.detail} ${crash.detail}" }
    }

    @Test
    fun `after a crash it is measured once more, in a folder where nothing of the crash lies`() {
        // Findings that are none show that the second try is what counts.
        assertEquals(FailureReason.CAPTURE_UNREADABLE, stopped(End.Signalled(6), next = End.Exited(0)).reason)
        assertEquals(2, tries.distinct().size)
        tries.clear()
        stopped(End.Exited(1))
        assertEquals(1, tries.size)
    }

    @Test
    fun `an end that is not agreed upon is the grader's own fault and costs nobody points`() {
        for (code in listOf(1, 2, 77)) assertEquals(FailureReason.INTERNAL, stopped(End.Exited(code), "at cga.grading…").reason, "$code")
    }

    @Test
    fun `what the process says is the reason's detail`() {
        val threw = stopped(End.Exited(6), "java.lang.IllegalStateException: no motorcycle\n  at Scene.kt:12\n")
        assertEquals(FailureReason.EXCEPTION, threw.reason)
        assertEquals("java.lang.IllegalStateException: no motorcycle\n  at Scene.kt:12", threw.detail)
        assertEquals(FailureReason.CAPTURE_UNREADABLE, stopped(End.Exited(3), "too long").reason)
        assertEquals(FailureReason.NOT_REPRODUCIBLE, stopped(End.Exited(4), "pixels differ").reason)
    }

    @Test
    fun `findings that are none are refused`() = assertEquals(FailureReason.CAPTURE_UNREADABLE, stopped(End.Exited(0)).reason)
}
