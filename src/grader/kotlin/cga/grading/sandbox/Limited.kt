package cga.grading.sandbox

import kotlin.math.ceil

/** The part of the limits that the kernel keeps, a little above those that are watched: a job that hits it is seen there and named. */
internal object Limited {
    private const val OPEN_FILES = 1024
    private const val SPARE_SECONDS = 2
    private const val SPARE_BYTES = 16L shl 20

    /** The command of [job] under the kernel's limits, as [user] where one is given; [ownTasks] where its tasks are counted by themselves. */
    fun command(job: Job, user: Int?, ownTasks: Boolean): List<String> {
        val become = user?.let {
            listOf("setpriv", "--reuid", "$it", "--regid", "$it", "--clear-groups") +
                listOf("--bounding-set=-all", "--inh-caps=-all", "--no-new-privs")
        }
        val limits = job.limits
        val tasks = if (ownTasks) listOf("--nproc=${2 * limits.tasks}") else emptyList()
        val cpu = ceil(limits.cpuSeconds).toLong() + SPARE_SECONDS
        // Only the job itself may enter its folders.
        val enter = listOf("env", "--chdir=${job.workingDirectory.toAbsolutePath()}")
        return become.orEmpty() + enter +
            listOf("prlimit", "--core=0", "--nofile=$OPEN_FILES", "--cpu=$cpu", "--fsize=${limits.diskBytes + SPARE_BYTES}") +
            tasks + job.command
    }
}

/** The job's whole environment. */
internal fun Job.fullEnvironment(): Map<String, String> =
    mapOf("PATH" to "/usr/bin:/bin", "HOME" to "${scratch.toAbsolutePath()}", "TMPDIR" to "/tmp", "LANG" to "C.UTF-8") + environment
