package cga.grading.sandbox

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

/**
 * Temporary files and folders of this process: all in one folder, which goes when the process ends, or, where that was killed, when the next
 * one makes its own. A process holds a lock on a file in its folder for as long as it lives.
 */
internal object Temporary {
    private const val PREFIX = "cga-grader-"
    private const val LOCK = "lock"

    private val root: Path = Path.of(System.getProperty("java.io.tmpdir"))

    // Kept: a channel that nobody refers to is closed, and its lock is lost.
    private var held: FileLock? = null
    private val home: Path by lazy {
        removeAbandoned()
        createTempDirectory(PREFIX).also { folder ->
            held = lock(folder)
            Runtime.getRuntime().addShutdownHook(Thread { Scratch.delete(folder) })
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
            lock(folder)?.use { Scratch.delete(folder) }
        }
    }

    /** Others may put what they like into a folder for all. */
    private fun isOurs(folder: Path): Boolean =
        try {
            Files.isDirectory(folder, NOFOLLOW_LINKS) && Files.getOwner(folder, NOFOLLOW_LINKS) == Files.getOwner(Path.of("/proc/self"))
        } catch (_: IOException) {
            false
        }

    /** The lock on [folder], which the process holds until it ends unless it is closed; null where somebody has it. */
    private fun lock(folder: Path): FileLock? =
        try {
            FileChannel.open(folder.resolve(LOCK), CREATE, WRITE, NOFOLLOW_LINKS).let { channel ->
                channel.tryLock() ?: null.also { channel.close() }
            }
        } catch (_: OverlappingFileLockException) {
            null
        } catch (_: NoSuchFileException) {
            // Another process was quicker.
            null
        }
}
