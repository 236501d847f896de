package cga.grading.sandbox

import cga.framework.InputError
import cga.framework.reason
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.FileLock
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import kotlin.io.path.createTempDirectory
import kotlin.io.path.createTempFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * Temporary files and folders of this process: all in one folder, which goes when the process ends, or, where that was killed, when the next
 * one makes its own. A process holds a lock on a file in its folder for as long as it lives.
 */
internal object Temporary {
    private const val PREFIX = "cga-grader-"
    private const val LOCK = "lock"
    private const val NEW = "new"

    private val root: Path = Path.of(System.getProperty("java.io.tmpdir"))

    // Kept: a channel that nobody refers to is closed, and its lock is lost.
    private var held: FileLock? = null
    private val home: Path by lazy {
        try {
            make()
        } catch (e: IOException) {
            throw InputError("cannot make files in the temporary folder $root (${e.reason()}): make room there.", e)
        }
    }

    private fun make(): Path {
        removeAbandoned()
        return createTempDirectory(PREFIX).also { folder ->
            // Locked before it has its name: nobody else finds it free.
            held = lock(folder.resolve(NEW))
            Files.move(folder.resolve(NEW), folder.resolve(LOCK))
            Runtime.getRuntime().addShutdownHook(Thread { remove(folder) })
        }
    }

    /** A new, empty folder. */
    fun folder(name: String): Path = createTempDirectory(home, "$name-")

    /** A new, empty file. */
    fun file(name: String): Path = createTempFile(home, "$name-", "")

    /** Removes what processes of this user have left that were killed. */
    fun removeAbandoned() {
        for (folder in root.listDirectoryEntries("$PREFIX*")) {
            if (!isOurs(folder)) continue
            // Between the folder and its lock there is a moment; nobody else's new folder is taken for an abandoned one.
            if (!Files.exists(folder.resolve(LOCK), NOFOLLOW_LINKS)) continue
            lock(folder.resolve(LOCK))?.use { remove(folder) }
        }
    }

    /** Removes [folder], the lock last: what a job that is just ending still writes there goes at the next start. */
    private fun remove(folder: Path) {
        val (lock, others) = folder.listDirectoryEntries().partition { it.name == LOCK }
        others.forEach(Scratch::delete)
        if (folder.listDirectoryEntries() == lock) Scratch.delete(folder)
    }

    /** Others may put what they like into a folder for all. */
    private fun isOurs(folder: Path): Boolean =
        try {
            Files.isDirectory(folder, NOFOLLOW_LINKS) && Files.getOwner(folder, NOFOLLOW_LINKS) == Files.getOwner(Path.of("/proc/self"))
        } catch (_: IOException) {
            false
        }

    /** The lock on [file], which the process holds until it ends unless it is closed; null where somebody has it. */
    private fun lock(file: Path): FileLock? =
        try {
            FileChannel.open(file, CREATE, WRITE, NOFOLLOW_LINKS).let { channel ->
                channel.tryLock() ?: null.also { channel.close() }
            }
        } catch (_: OverlappingFileLockException) {
            null
        } catch (_: NoSuchFileException) {
            // Another process was quicker.
            null
        }
}
