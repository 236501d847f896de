package cga.grading.pipeline

import cga.framework.InputError
import cga.grading.findings.Check
import cga.grading.findings.FailureReason
import cga.grading.findings.Findings
import cga.grading.findings.FindingsFile
import cga.grading.findings.LikenessFile
import cga.grading.prepared.Edition
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.SafeFiles
import cga.grading.sandbox.Sandbox
import java.nio.file.Path
import kotlin.io.path.writeBytes

/** Measures a capture in the sandbox, in a process that has none of the submission's classes: only its shaders run there. */
internal class MeasureStep(
    private val sandbox: Sandbox,
    private val programs: Programs,
    private val limits: Limits,
) {
    /** The findings, their pictures put into [folder]; see [SecondTry] for a crash. Throws [Stopped]. */
    fun measure(edition: Edition, capture: Path, scratch: Path, folder: Path, run: Run): Findings {
        val (outcome, measured) = SecondTry.after(scratch) { attempt(edition, capture, it, run) }
        return findings(outcome, measured, folder, run)
    }

    private fun attempt(edition: Edition, capture: Path, scratch: Path, run: Run): Outcome {
        val arguments = listOf(capture.toString(), scratch.toString(), edition.id)
        val command = JavaCommand(programs.own, MAIN, arguments, options = programs.ownArchive.options).command()
        val readOnly = programs.own + listOfNotNull(programs.ownArchive.file, capture)
        val environment = JavaCommand.mesaCachingIn(scratch.resolve("shaders"))
        return sandbox.run(Job(command, scratch, readOnly, environment, limits = limits)).also { run.note("measuring", it) }
    }

    private fun findings(outcome: Outcome, scratch: Path, folder: Path, run: Run): Findings {
        // Nothing of the submission's but its shaders runs there: they are what took too long or brought the driver down.
        checkEnd("Drawing with its shaders", outcome, CODES, FailureReason.INTERNAL)
        return try {
            run.compare(LikenessFile.read(scratch))
            FindingsFile.read(scratch).also(::checkComplete).also { copyPictures(it, scratch, folder) }
        } catch (e: InputError) {
            throw Stopped(FailureReason.CAPTURE_UNREADABLE, e.message.orEmpty())
        }
    }

    private fun checkComplete(findings: Findings) {
        val missing = Check.entries - findings.checks.map { it.check }.toSet()
        if (missing.isNotEmpty()) throw InputError("the findings lack ${missing.joinToString { it.id }}.")
    }

    private fun copyPictures(findings: Findings, from: Path, to: Path) {
        for (name in findings.pictures.flatMap { listOfNotNull(it.measured, it.expected) }.distinct()) {
            to.resolve(name).writeBytes(SafeFiles.read(from, name, MOST_PICTURE_BYTES))
        }
    }

    private companion object {
        const val MAIN = "cga.grading.analysis.AnalysisMain"
        const val MOST_PICTURE_BYTES = 16L shl 20
        val CODES =
            mapOf(
                2 to FailureReason.INTERNAL,
                3 to FailureReason.CAPTURE_UNREADABLE,
                4 to FailureReason.NOT_REPRODUCIBLE,
                5 to FailureReason.NOTHING_DRAWN,
                6 to FailureReason.EXCEPTION,
                7 to FailureReason.EXITED,
                8 to FailureReason.OUT_OF_MEMORY,
            )
    }
}
