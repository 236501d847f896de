package cga.grading.pipeline

import cga.grading.capture.WorkerFiles
import cga.grading.capture.WorkerRun
import cga.grading.findings.FailureReason
import cga.grading.prepared.PreparedTree
import cga.grading.sandbox.End
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.SafeFiles
import cga.grading.sandbox.Sandbox
import java.nio.file.Path
import kotlin.io.path.createDirectories

/** Runs a submission in the sandbox, played by the script; what it draws is captured. */
internal class CaptureStep(
    private val sandbox: Sandbox,
    private val programs: Programs,
    private val limits: Limits,
) {
    /**
     * The capture file, which nobody has looked into yet, of the submission in [tree]; see [SecondTry] for a crash. Throws [Stopped]
     * where there is none.
     */
    fun capture(tree: PreparedTree, main: String, compiled: Compiled, scratch: Path, run: Run): Path {
        val (outcome, folder) = SecondTry.after(scratch) { attempt(tree, main, compiled, it, run) }
        return captured(outcome, folder)
    }

    private fun attempt(tree: PreparedTree, main: String, compiled: Compiled, scratch: Path, run: Run): Outcome {
        val command = WorkerFiles.command(
            WorkerRun(
                compiled.classes + compiled.runtime,
                programs.worker,
                main,
                scratch.resolve(NAME),
                programs.workerArchive.options,
            ),
        )
        val readOnly = programs.readable + compiled.runtime + compiled.classes + listOf(tree.start)
        return sandbox
            .run(Job(command, scratch, readOnly, JavaCommand.MESA + NO_SOUND, workingDirectory = tree.start, limits = limits))
            .also { run.note("the program's output", it) }
    }

    private fun captured(outcome: Outcome, scratch: Path): Path {
        // Any code may be the submission's own: that there is no OpenGL is believed to a program of ours only.
        if (outcome.end == End.Exited(NO_OPENGL) && !hasOpenGl(scratch)) {
            throw Stopped(FailureReason.INTERNAL, "No OpenGL window can be made in the sandbox.\n${outcome.errors.trim().take(MOST_SAID)}")
        }
        checkEnd("The program", outcome)
        if (!SafeFiles.exists(scratch, NAME)) throw Stopped(FailureReason.EXITED, "The program ended before anything was captured.")
        return scratch.resolve(NAME)
    }

    private fun hasOpenGl(scratch: Path): Boolean {
        val own = scratch.resolveSibling("trial").createDirectories()
        val command = WorkerFiles.command(WorkerRun(emptyList(), programs.worker, TRIAL, own.resolve(NAME)))
        return sandbox.run(Job(command, own, programs.readable, JavaCommand.MESA, limits = limits)).isSuccess
    }

    private companion object {
        const val NAME = "capture.bin"
        const val NO_OPENGL = 3
        const val TRIAL = "cga.grading.worker.Trial"
        const val MOST_SAID = 1000

        /** OpenAL without a device, for games that would end without one. */
        val NO_SOUND = mapOf("ALSOFT_DRIVERS" to "null")
    }
}
