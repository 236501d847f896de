package cga.grading.sandbox

import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** What all processes of a tree use together at one moment. */
internal class TreeUse(
    val tasks: Int,
    val memoryBytes: Long,
    val cpuSeconds: Double,
)

/**
 * The process [root] and all that came of it, read from `/proc`.
 *
 * Once a process belongs to the tree it stays in it, also when its parent dies; a process of the same session belongs to it too.
 */
internal class ProcessTree(
    private val root: Long,
) {
    private val members = HashMap<Long, Long>()
    private var strangers = HashSet<Long>()

    /** Ticks of processes that are gone and that no parent was charged with yet. */
    private var mostTicks = 0L

    /** Looks at every process of the machine that is not known to be a stranger. */
    @Synchronized
    fun look(): TreeUse {
        val numbers = File("/proc").list().orEmpty().mapNotNull { it.toLongOrNull() }
        // What was no member before cannot become one, unless its number was given anew: then it has been away at some look.
        strangers.retainAll(numbers.toHashSet())
        val seen = numbers.filter { it !in strangers }.mapNotNull(::read)
        do {
            val grown = seen.count { it.number !in members && belongs(it) && members.put(it.number, it.start) == null }
        } while (grown > 0)
        val (ours, others) = seen.partition { members[it.number] == it.start }
        others.mapTo(strangers) { it.number }
        members.keys.retainAll(ours.mapTo(HashSet()) { it.number })
        // A tree's time never shrinks: what seems to is a child that nobody waited for.
        mostTicks = maxOf(mostTicks, ours.sumOf { it.ticks })
        return TreeUse(ours.sumOf { it.threads }, ours.sumOf { it.pages } * PAGE_BYTES, mostTicks / TICKS_A_SECOND)
    }

    private fun belongs(process: Seen) = process.number == root || process.parent in members || process.session == root

    /** Bytes of files that processes of the tree hold open though they are deleted, memory files among them; each file once. */
    @Synchronized
    fun deletedBytes(): Long {
        val files = HashMap<Any, Long>()
        for (process in members.keys) {
            for (file in File("/proc/$process/fd").listFiles().orEmpty()) deleted(file.toPath())?.let { files += it }
        }
        return files.values.sum()
    }

    /** For how many seconds tasks of the tree were ready to run while others had the processors, all tasks together. */
    @Synchronized
    fun waitedSeconds(): Double =
        members.keys.flatMap { File("/proc/$it/task").listFiles().orEmpty().asList() }.sumOf(::waitedNanoseconds) / 1e9

    private fun waitedNanoseconds(task: File): Long =
        try {
            task.resolve("schedstat").readText().split(' ').getOrNull(1)?.toLongOrNull() ?: 0
        } catch (_: IOException) {
            // It ended meanwhile, or the kernel does not count.
            0
        }

    private fun deleted(file: Path): Pair<Any, Long>? =
        try {
            val attributes = Files.readAttributes(file, "unix:nlink,size,dev,ino,mode")
            val isFile = (attributes["mode"] as Int) and FILE_KIND == REGULAR_FILE
            if (isFile && attributes["nlink"] == 0) (attributes["dev"] to attributes["ino"]) to attributes["size"] as Long else null
        } catch (_: IOException) {
            null
        }

    /** Kills every member, those that are born meanwhile included. True when none is left. */
    fun kill(): Boolean {
        for (round in 0 until KILL_ROUNDS) {
            look()
            val alive = synchronized(this) { members.toMap() }
            if (alive.isEmpty()) return true
            for ((number, start) in alive) {
                // The number may be somebody else's by now.
                if (read(number)?.start == start) ProcessHandle.of(number).ifPresent { if (it.isAlive) it.destroyForcibly() }
            }
            Thread.sleep(KILL_PAUSE)
        }
        return false
    }

    private class Seen(val number: Long, fields: List<String>) {
        val isDead = fields[0] == "Z" || fields[0] == "X"
        val parent = fields[1].toLong()
        val session = fields[3].toLong()

        /** Its own and those of the children that it waited for. */
        val ticks = fields.subList(11, 15).sumOf { it.toLong() }
        val threads = if (isDead) 0 else fields[17].toInt()
        val start = fields[19].toLong()
        val pages = fields[21].toLong()
    }

    /** Process [number], null when it is gone or only waits for its parent to notice its end. */
    private fun read(number: Long): Seen? =
        try {
            // The name stands in brackets and may hold anything, brackets and line ends too.
            val text = Files.readString(Path.of("/proc/$number/stat"), Charsets.ISO_8859_1)
            Seen(number, text.substring(text.lastIndexOf(')') + 2).trim().split(' ')).takeUnless { it.isDead }
        } catch (_: IOException) {
            null
        }

    private companion object {
        // Half a minute: on a machine with too much to do it takes seconds to die.
        const val KILL_ROUNDS = 3000
        const val KILL_PAUSE = 10L
        const val FILE_KIND = 0xf000
        const val REGULAR_FILE = 0x8000

        /** What Linux shows to programs, whatever its own clock. */
        const val TICKS_A_SECOND = 100.0

        /** 4 KiB but on some ARM machines. */
        val PAGE_BYTES: Long = File("/proc/self/smaps").useLines { lines ->
            lines.first { it.startsWith("KernelPageSize:") }.filter(Char::isDigit).toLong() * 1024
        }
    }
}
