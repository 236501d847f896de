package cga.grading.pipeline

import cga.grading.sandbox.Job
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.Sandbox
import java.nio.file.Path
import java.util.zip.CRC32
import kotlin.io.path.createTempDirectory
import kotlin.io.path.readBytes
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/** [sandbox], but what has been compiled already from the same sources is copied; all else is really run. Counts the jobs. */
internal class CompileOnce(
    private val sandbox: Sandbox,
) : Sandbox {
    private class Compiled(
        val classes: Path,
        val outcome: Outcome,
    )

    private val kept = HashMap<Long, Compiled>()

    override fun run(job: Job): Outcome = if (COMPILER in job.command) compile(job) else sandbox.run(job)

    /** One at a time: who waits will most likely find it done. */
    @Synchronized
    private fun compile(job: Job): Outcome {
        val classes = job.scratch.resolve("classes")
        val known = kept[sum(job.scratch.resolve("sources"))]
        if (known != null) {
            known.classes.toFile().copyRecursively(classes.toFile(), overwrite = true)
            return known.outcome
        }
        val outcome = sandbox.run(job)
        if (outcome.isSuccess) {
            val copy = createTempDirectory("compiled")
            classes.toFile().copyRecursively(copy.toFile(), overwrite = true)
            kept[sum(job.scratch.resolve("sources"))] = Compiled(copy, outcome)
        }
        return outcome
    }

    fun clear(): Unit = kept.values.forEach { it.classes.toFile().deleteRecursively() }

    private fun sum(sources: Path): Long =
        CRC32().run {
            for (file in sources.walk().sorted()) {
                update("${file.relativeTo(sources)}".toByteArray())
                update(file.readBytes())
            }
            value
        }

    private companion object {
        const val COMPILER = "org.jetbrains.kotlin.cli.jvm.K2JVMCompiler"
    }
}
