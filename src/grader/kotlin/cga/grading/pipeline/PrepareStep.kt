package cga.grading.pipeline

import cga.framework.Home
import cga.framework.InputError
import cga.grading.findings.FailureReason
import cga.grading.prepared.Edition
import cga.grading.prepared.Kind
import cga.grading.prepared.PreparedTree
import cga.grading.sandbox.End
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.Sandbox
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists

/** Has what was handed in read in the sandbox: unpacked, recognised, and laid out as a plain tree. Nothing else ever looks at it. */
internal class PrepareStep(
    private val sandbox: Sandbox,
    private val programs: Programs,
    private val limits: Limits,
    private val edition: Edition?,
) {
    /** The tree that becomes of [given], below [work]. Throws [Stopped]. */
    fun prepare(given: Path, work: Path): PreparedTree {
        if (!given.exists()) throw Stopped(FailureReason.MISSING, "$given does not exist: name the folder or the archive of a submission.")
        val first = work.resolve("first").createDirectories()
        val outcome = attempt(given.toRealPath(), first)
        if (outcome.end != End.Exited(UNREADABLE)) return tree(outcome, first)
        val copy = work.resolve("copy").also { InputCopy.write(given, it) }
        val second = work.resolve("second").createDirectories()
        return tree(attempt(copy, second), second)
    }

    private fun attempt(given: Path, scratch: Path): Outcome {
        val home = Home.resolve("").toAbsolutePath()
        val arguments = listOf("$given", "$scratch", edition?.id.orEmpty())
        val command = JavaCommand(programs.own, MAIN, arguments, options = programs.ownArchive.options + "-Dcga.home=$home").command()
        val ours = (listOf("assets") + Kind.entries.map { it.reference }).map(home::resolve)
        return sandbox.run(
            Job(command, scratch, programs.own + listOfNotNull(programs.ownArchive.file) + ours + listOf(given), limits = limits),
        )
    }

    private fun tree(outcome: Outcome, scratch: Path): PreparedTree =
        try {
            checkEnd("Reading it", outcome, CODES, FailureReason.INTERNAL)
            PreparedTree.read(scratch)
        } catch (e: InputError) {
            throw Stopped(FailureReason.INTERNAL, e.message.orEmpty())
        } catch (e: Stopped) {
            throw when (outcome.end) {
                // Only our own program runs there: what takes it beyond its limits is what it reads.
                is End.Exceeded -> Stopped(FailureReason.UNPACK_REFUSED, e.detail)
                is End.Signalled -> Stopped(FailureReason.INTERNAL, e.detail)
                is End.Exited -> e
            }
        }

    companion object {
        const val MAIN = "cga.grading.submission.PrepareMain"
        private const val UNREADABLE = 5
        private val CODES = mapOf(3 to FailureReason.NOT_RECOGNIZED, 4 to FailureReason.UNPACK_REFUSED)
    }
}
