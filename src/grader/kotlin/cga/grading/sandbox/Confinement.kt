package cga.grading.sandbox

import cga.framework.InputError
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ThreadLocalRandom
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.readSymbolicLink
import kotlin.io.path.writeBytes

/**
 * How bubblewrap is used on this machine.
 *
 * Root gives each job a user number of its own that nobody else has, so that the kernel's limit on processes counts and files of root are
 * out of reach. Anybody else gets a user namespace. Both have namespaces of their own for all else, no capabilities and a [SeccompFilter].
 *
 * @param ownUser whether jobs run under a user number of their own.
 * @param boundsMemoryFiles whether bubblewrap can bound a file system in memory, as it can from 0.7 on. Where it cannot, a job's `/tmp`
 * is a folder on the disk, which counts like its scratch folder, and it has no shared memory.
 */
internal class Confinement private constructor(
    private val ownUser: Boolean,
    private val filter: Path,
    private val boundsMemoryFiles: Boolean,
) {
    /** This one as it would be with an older bubblewrap. */
    fun withoutBounds(): Confinement = Confinement(ownUser, filter, boundsMemoryFiles = false)

    /** A new folder that is to be a job's `/tmp`, null where it needs none. To be deleted when the job has ended. */
    fun temporaryFolder(): Path? = if (boundsMemoryFiles) null else Temporary.folder("tmp")

    /**
     * The command that runs [job] confined.
     *
     * @param temporary what [temporaryFolder] made for it.
     * @param status a file that bubblewrap writes its own account to: it holds `exit-code` once the job has really run.
     */
    fun command(job: Job, temporary: Path?, status: Path): List<String> {
        val user = if (ownUser) ThreadLocalRandom.current().nextInt(FIRST_USER, LAST_USER) else null
        user?.let { listOfNotNull(job.scratch, temporary).forEach { folder -> own(folder, it) } }
        // Java cannot hand an open file to a child; a shell can.
        val shell = listOf("/bin/sh", "-c", "f=\$1 s=\$2; shift 2; exec \"\$@\" 9<\"\$f\" 8>\"\$s\"", "sh", "$filter", "$status")
        return shell + BWRAP + walls() + system() + places(job, temporary) + environment(job) +
            listOf("--") + Limited.command(job, user, ownTasks)
    }

    /** The kernel counts a user's tasks in each user namespace by itself from 5.14 on; before, the grader's own would count. */
    private val ownTasks = ownUser || kernelCountsByNamespace()

    private fun walls() =
        (if (ownUser) ALL_BUT_USERS else listOf("--unshare-all", "--uid", "$NOBODY", "--gid", "$NOBODY")) +
            listOf("--die-with-parent", "--new-session", "--cap-drop", "ALL") +
            // Only to give up the rest of root; gone before the job's first instruction.
            (if (ownUser) listOf("CAP_SETUID", "CAP_SETGID", "CAP_SETPCAP").flatMap { listOf("--cap-add", it) } else emptyList()) +
            listOf("--hostname", "sandbox", "--seccomp", "9", "--json-status-fd", "8")

    private fun system(): List<String> =
        listOf("--perms", "0755", "--dir", "/usr") + USR.flatMap { readOnly(Path.of(it)) } + LINKED.flatMap(::linked) +
            folder(Path.of("/etc")) + etc().flatMap(::readOnly) +
            listOf("--proc", "/proc", "--dev", "/dev") +
            (if (boundsMemoryFiles) inMemory("/dev/shm", SHARED_MEMORY) else emptyList()) + listOf("--remount-ro", "/dev")

    /** `/lib` and its like are links into `/usr` on most machines, and folders on others. */
    private fun linked(name: String): List<String> {
        val path = Path.of(name)
        return if (path.isSymbolicLink()) listOf("--symlink", "${path.readSymbolicLink()}", name) else readOnly(path)
    }

    private fun etc(): List<Path> {
        val jdks = Path.of("/etc").toFile().list().orEmpty().filter { it.startsWith("java") }
        return (ETC + jdks).map { Path.of("/etc").resolve(it) }
    }

    private fun inMemory(path: String, bytes: Long) = listOf("--size", "$bytes", "--perms", "1777", "--tmpfs", path)

    private fun places(job: Job, temporary: Path?): List<String> {
        val tmp = temporary?.let { listOf("--bind", "${it.toAbsolutePath()}", "/tmp") } ?: inMemory("/tmp", job.limits.temporaryBytes)
        val readable = (job.readOnly + listOf(Path.of(System.getProperty("java.home")))).map { it.toAbsolutePath().normalize() }.distinct()
        val scratch = job.scratch.toAbsolutePath()
        // A folder before what lies in it, or the one would hide the other.
        val places = (readable.filter(Files::exists).map { it to "--ro-bind" } + (scratch to "--bind")).sortedBy { it.first.nameCount }
        return tmp + places.flatMap { (path, how) -> folders(path) + listOf(how, "$path", "$path") } + listOf("--remount-ro", "/")
    }

    private fun readOnly(path: Path) = if (Files.exists(path)) folders(path) + listOf("--ro-bind", "$path", "$path") else emptyList()

    /** The folders that lead to [path]: made by bubblewrap itself, only root could pass through them. */
    private fun folders(path: Path): List<String> =
        generateSequence(path.parent) { it.parent }.toList().reversed().drop(1).filterNot { "$it" in PRESENT }.flatMap(::folder)

    private fun folder(path: Path) = listOf("--perms", "0755", "--dir", "$path")

    private fun environment(job: Job) =
        listOf("--clearenv") + job.fullEnvironment().flatMap { (name, value) -> listOf("--setenv", name, value) }

    internal companion object {
        private const val BWRAP = "bwrap"
        private const val SHARED_MEMORY = 16L shl 20

        private const val NOBODY = 65534

        /** Far above all numbers that are handed out to people, services and containers. */
        private const val FIRST_USER = 0x70000000
        private const val LAST_USER = 0x7f000000

        private val ALL_BUT_USERS = listOf("ipc", "pid", "net", "uts", "cgroup-try").map { "--unshare-$it" }
        private val USR = listOf("bin", "sbin", "lib", "lib32", "lib64", "libx32", "libexec", "share", "local/lib").map { "/usr/$it" }
        private val LINKED = listOf("/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32")
        private val ETC = listOf("alternatives", "ld.so.cache", "ld.so.conf", "ld.so.conf.d", "fonts", "glvnd", "drirc", "localtime")
        private val PRESENT = setOf("/", "/usr", "/tmp", "/etc")

        private val found: Result<Confinement> by lazy { runCatching(::search) }

        /** The confinement that works here, or an [InputError] that says why none does. Tried once. */
        fun find(): Result<Confinement> = found

        private fun search(): Confinement {
            if (System.getProperty("os.name") != "Linux") throw InputError("no sandbox: bubblewrap needs Linux. $OTHERWISE")
            val program = SeccompFilter.forThisMachine()
                ?: throw InputError("no sandbox: the system calls of ${System.getProperty("os.arch")} are not known here. $OTHERWISE")
            val tools = listOf(BWRAP, "prlimit", "setpriv").filterNot(::isInstalled)
            if (tools.isNotEmpty()) {
                throw InputError("no sandbox: ${tools.joinToString()} not found. Install bubblewrap and util-linux. $OTHERWISE")
            }
            val filter = Temporary.file("seccomp").apply { writeBytes(program) }
            val isRoot = Files.getAttribute(Path.of("/proc/self"), "unix:uid") == 0
            val boundsMemoryFiles = "--size" in said(BWRAP, "--help")
            val ways = (if (isRoot) listOf(true, false) else listOf(false)).map { Confinement(it, filter, boundsMemoryFiles) }
            val failures = ways.map { way -> tryOut(way) ?: return way }
            throw InputError("no sandbox: bubblewrap cannot make one here (${failures.last()}). ${Forbidden.causes()} $OTHERWISE")
        }

        private fun said(vararg command: String): String {
            val process = ProcessBuilder(*command).redirectErrorStream(true).start()
            process.outputStream.close()
            return process.inputReader().use { it.readText() }
        }

        private fun isInstalled(tool: String) = listOf("/usr/bin", "/bin", "/usr/local/bin").any { Files.isExecutable(Path.of(it, tool)) }

        /** What [way] says when it is used, null when all is well. */
        private fun tryOut(way: Confinement): String? {
            val scratch = Temporary.folder("trial")
            return try {
                val outcome = ConfinedRun(way).run(Job(listOf("true"), scratch, limits = Limits(wallSeconds = 20.0)))
                if (outcome.isSuccess) null else "${outcome.end} ${outcome.errors.trim()}"
            } catch (e: InputError) {
                e.message
            } finally {
                Scratch.delete(scratch)
            }
        }

        private fun kernelCountsByNamespace(): Boolean {
            val (major, minor) = Regex("""^(\d+)\.(\d+)""").find(System.getProperty("os.version"))?.destructured ?: return false
            return major.toInt() * 1000 + minor.toInt() >= 5014
        }

        private fun own(folder: Path, user: Int) = Scratch.giveTo(folder, user)

        private const val OTHERWISE = "--unsafe-no-sandbox runs submissions without one: only on a machine that is thrown away afterwards."
    }
}
