package cga.grading.pipeline

import cga.grading.capture.WorkerFiles
import cga.grading.capture.WorkerRun
import cga.grading.findings.FailureReason
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.SafeFiles
import cga.grading.sandbox.Sandbox
import cga.grading.submission.Submission
import java.nio.file.Path

/** Runs a submission in the sandbox, played by the script; what it draws is captured. */
internal class CaptureStep(
    private val sandbox: Sandbox,
    private val programs: Programs,
) {
    /** The capture file, which nobody has looked into yet. Throws [Stopped] where there is none. */
    fun capture(submission: Submission, main: String, compiled: Compiled, scratch: Path, run: Run): Path {
        val file = scratch.resolve(NAME)
        val command = WorkerFiles.command(WorkerRun(listOf(compiled.classes), programs.worker, main, file))
        val readOnly = programs.readable + compiled.runtime + listOf(compiled.classes, submission.root)
        val outcome =
            sandbox.run(Job(command, scratch, readOnly, JavaCommand.MESA, workingDirectory = submission.workingDirectory, limits = LIMITS))
        run.note("the program's output", outcome)
        checkEnd("The program", outcome, mapOf(NO_OPENGL to FailureReason.INTERNAL))
        if (!SafeFiles.exists(scratch, NAME)) throw Stopped(FailureReason.EXITED, "The program ended before anything was captured.")
        return file
    }

    private companion object {
        const val NAME = "capture.bin"
        const val NO_OPENGL = 3

        /** An honest run takes about 3 s of processor time and 450 MB. */
        val LIMITS = Limits(wallSeconds = 60.0, cpuSeconds = 60.0)
    }
}
