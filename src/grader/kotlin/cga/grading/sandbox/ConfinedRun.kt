package cga.grading.sandbox

import cga.framework.InputError
import java.io.File
import java.io.IOException
import java.nio.file.Files
import kotlin.io.path.deleteIfExists
import kotlin.io.path.fileSize
import kotlin.io.path.readText

/** Runs jobs inside a [Confinement]. */
internal class ConfinedRun(
    private val confinement: Confinement,
) : Sandbox {
    override fun run(job: Job): Outcome {
        requireFolders(job)
        val status = Temporary.file("status")
        val temporary = confinement.temporaryFolder()
        try {
            val outcome =
                Watch(job, start(confinement.command(job, temporary, status), emptyMap()), listOfNotNull(job.scratch, temporary)).untilEnd()
            // Bubblewrap's own failures end it like a job of exit code 1, but then there was no job.
            val hasRun = status.fileSize() < LONGEST_STATUS && "exit-code" in status.readText()
            if (outcome.end is End.Exited && !hasRun) {
                throw InputError("the sandbox did not start ${job.command.first()}: ${outcome.errors.trim()}")
            }
            return outcome
        } finally {
            status.deleteIfExists()
            temporary?.let(Scratch::delete)
        }
    }

    private companion object {
        const val LONGEST_STATUS = 10_000L
    }
}

/** Runs jobs with limits only. */
internal class UnconfinedRun : Sandbox {
    override val isConfined: Boolean get() = false

    override fun run(job: Job): Outcome {
        requireFolders(job)
        val limited = Limited.command(job, user = null, ownTasks = false)
        // A session of its own is how orphans are recognised.
        val environment = job.fullEnvironment() + ("TMPDIR" to System.getProperty("java.io.tmpdir"))
        return Watch(job, start(listOf("setsid") + limited, environment), listOf(job.scratch)).untilEnd()
    }
}

private fun requireFolders(job: Job) {
    val missing = listOf(job.scratch, job.workingDirectory).firstOrNull { !Files.isDirectory(it) }
    if (missing != null) throw InputError("the folder $missing does not exist.")
}

private fun start(command: List<String>, environment: Map<String, String>): Process {
    val builder = ProcessBuilder(command).redirectInput(File("/dev/null"))
    builder.environment().run {
        val path = this["PATH"]
        clear()
        path?.let { put("PATH", it) }
        putAll(environment)
    }
    return try {
        builder.start()
    } catch (e: IOException) {
        throw InputError("${command.first()} cannot be started (${e.message}): is it installed?", e)
    }
}
