package cga.grading.course

import cga.framework.InputError
import cga.framework.reason
import cga.grading.findings.Graded
import cga.grading.findings.Refused
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * The folder of a course's results, of which one process at a time may write. A submission is made in a folder of its own in `.staging` and
 * moved to its place as a whole: whatever is killed, a result is there completely or not at all.
 */
public class ResultStore private constructor(
    public val out: Path,
    private val lock: FileChannel,
) : AutoCloseable {
    private val staging = out.resolve(STAGING)
    internal val journal = Journal(out.resolve(Journal.NAME))

    /** Where [folder] of a submission is or will be. */
    internal fun folder(folder: String): Path = out.resolve(folder)

    /**
     * The result of the submission called [folder], where it was made from the same input. Anything unreadable is as good as none, and so is
     * a failure that was not the submission's: it is tried again.
     */
    internal fun find(folder: String, checksum: String): StoredOutcome? =
        try {
            OutcomeFile.read(folder(folder)).takeIf {
                it.checksum == checksum && checksum != "missing" &&
                    (it.outcome as? Refused)?.reason?.isItsOwn != false
            }
        } catch (_: InputError) {
            null
        }

    /** An empty folder to make the result of [folder] in. */
    @OptIn(ExperimentalPathApi::class)
    internal fun stage(folder: String): Path = staging.resolve(folder).apply { deleteRecursively() }.createDirectories()

    /** Puts [stored], made in [staged], in its place. Throws [IllegalArgumentException] or [InputError] where it is not fit to be kept. */
    internal fun commit(stored: StoredOutcome, staged: Path) {
        val outcome = stored.outcome
        val pictures = (outcome as? Graded)?.findings?.pictures.orEmpty().flatMap { listOfNotNull(it.measured, it.expected) }
        removeAllBut(pictures.toSet(), staged)
        OutcomeFile.write(stored, staged)
        // Read as it will be read: what breaks a limit is found now, while it can still be said.
        OutcomeFile.read(staged)
        place(staged)
    }

    /** Moves a complete folder from staging to its place. */
    @OptIn(ExperimentalPathApi::class)
    internal fun place(staged: Path) {
        val target = folder(staged.name)
        target.deleteRecursively()
        Files.move(staged, target, ATOMIC_MOVE)
    }

    @OptIn(ExperimentalPathApi::class)
    private fun removeAllBut(names: Set<String>, folder: Path) =
        folder.listDirectoryEntries().filter { it.name !in names }.forEach { it.deleteRecursively() }

    @OptIn(ExperimentalPathApi::class)
    override fun close() {
        staging.deleteRecursively()
        lock.close()
    }

    public companion object {
        private const val STAGING = ".staging"
        private const val LOCK = ".lock"

        /**
         * Opens the folder [out], which is made where it is missing. Throws [InputError] where it is in use, cannot be written, holds
         * something else, or holds results and [resume] is false.
         */
        @OptIn(ExperimentalPathApi::class)
        public fun open(out: Path, resume: Boolean): ResultStore {
            if (Files.exists(out) && !Files.isDirectory(out)) throw InputError("--out $out is a file: name a folder.")
            try {
                out.createDirectories()
                val isOurs = out.resolve(Manifest.NAME).exists()
                val strangers = out.listDirectoryEntries().filter { it.name !in setOf(LOCK, STAGING) }
                if (isOurs &&
                    !resume
                ) {
                    throw InputError("--out $out holds results: give --resume to go on with them, or name another folder.")
                }
                if (!isOurs && strangers.isNotEmpty()) {
                    throw InputError("--out $out holds other things (${strangers.first().name}): name a new or an empty folder.")
                }
                val lock = lock(out)
                out.resolve(STAGING).deleteRecursively()
                return ResultStore(out, lock)
            } catch (e: IOException) {
                throw InputError("cannot write to --out $out (${e.reason()}): name a folder that can be written.", e)
            }
        }

        private fun lock(out: Path): FileChannel {
            val channel = FileChannel.open(out.resolve(LOCK), CREATE, WRITE)
            val isFree =
                try {
                    channel.tryLock() != null
                } catch (_: OverlappingFileLockException) {
                    false
                } catch (_: IOException) {
                    // A file system without locks: then it is up to the user not to start two.
                    true
                }
            if (isFree) return channel
            channel.close()
            throw InputError("another cga grade is writing to --out $out: wait for it, or name another folder.")
        }
    }
}
