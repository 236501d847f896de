package cga.grading.sandbox

import java.nio.file.Path
import java.util.concurrent.TimeUnit.MILLISECONDS

/** Watches over a running [job], which fills [folders], until it ends or goes past a limit. */
internal class Watch(
    private val job: Job,
    private val process: Process,
    private val folders: List<Path>,
) {
    private val started = System.nanoTime()
    private val limits = job.limits
    private val output = Drain(process.inputStream, limits.keptBytes)
    private val errors = Drain(process.errorStream, limits.keptBytes)
    private val tree = ProcessTree(process.pid())
    private var cpuSeconds = 0.0
    private var peakMemory = 0L
    private var peakTasks = 0
    private var nextDiskLook = 0.0

    /** Returns when no process of the job is alive any more. */
    fun untilEnd(): Outcome {
        var exceeded: Limit? = null
        try {
            exceeded = tree.breach()
            val period = (1000 * limits.lookSeconds).toLong()
            while (exceeded == null && !process.waitFor(period, MILLISECONDS)) exceeded = tree.breach()
        } finally {
            // Also when this thread is interrupted: nothing is left behind. A Process would close its streams, with what was said last in them.
            process.toHandle().destroyForcibly()
            check(tree.kill()) { "processes of ${job.command.first()} survive SIGKILL" }
        }
        val seconds = elapsed()
        process.waitFor()
        val texts = output.finish() to errors.finish()
        return Outcome(exceeded?.let(End::Exceeded) ?: ownEnd(), texts.first, texts.second, seconds, cpuSeconds, peakMemory)
    }

    private fun ProcessTree.breach(): Limit? {
        val use = look()
        cpuSeconds = maxOf(cpuSeconds, use.cpuSeconds)
        peakMemory = maxOf(peakMemory, use.memoryBytes)
        peakTasks = maxOf(peakTasks, use.tasks)
        return when {
            use.tasks > limits.tasks -> Limit.PROCESSES
            use.memoryBytes > limits.memoryBytes -> Limit.MEMORY
            output.total + errors.total > limits.outputBytes -> Limit.OUTPUT
            use.cpuSeconds > limits.cpuSeconds -> timeOr(Limit.CPU)
            isTimeOver() -> timeOr(Limit.WALL_CLOCK)
            isDiskOver() -> Limit.DISK
            else -> null
        }
    }

    /** On a machine that has too much to do the job's clock stands still while it waits for a processor, as far as that goes. */
    private fun ProcessTree.isTimeOver(): Boolean {
        val elapsed = elapsed()
        if (elapsed <= limits.wallSeconds) return false
        return elapsed > MOST_STRETCH * limits.wallSeconds || elapsed - waitedSeconds() > limits.wallSeconds
    }

    // On a busy machine processes that multiply use the time up between two looks; a JVM that draws has some forty threads.
    private fun timeOr(limit: Limit): Limit = if (peakTasks > limits.tasks / 2) Limit.PROCESSES else limit

    /** Looks at the disk less often than at the rest, and the less often the longer it takes. */
    private fun isDiskOver(): Boolean {
        val before = elapsed()
        if (before < nextDiskLook) return false
        val isOver = Scratch.isOver(folders, limits, tree.deletedBytes())
        nextDiskLook = elapsed() + maxOf(DISK_PERIOD, DISK_SHARE * (elapsed() - before))
        return isOver
    }

    /** How it ended by itself, unless the kernel's limit or the last moment says otherwise. */
    private fun ownEnd(): End {
        val code = process.exitValue()
        return when {
            output.total + errors.total > limits.outputBytes -> End.Exceeded(Limit.OUTPUT)
            Scratch.isOver(folders, limits, 0) -> End.Exceeded(Limit.DISK)
            code == SIGNALLED + SIGXCPU -> End.Exceeded(Limit.CPU)
            code == SIGNALLED + SIGXFSZ -> End.Exceeded(Limit.DISK)
            code > SIGNALLED && code <= SIGNALLED + LAST_SIGNAL -> End.Signalled(code - SIGNALLED)
            else -> End.Exited(code)
        }
    }

    private fun elapsed() = (System.nanoTime() - started) / 1e9

    private companion object {
        const val DISK_PERIOD = 0.2

        /** Many tasks that wait a little could stretch the time without end. */
        const val MOST_STRETCH = 8.0
        const val DISK_SHARE = 10.0
        const val SIGNALLED = 128
        const val LAST_SIGNAL = 64
        const val SIGXCPU = 24
        const val SIGXFSZ = 25
    }
}
