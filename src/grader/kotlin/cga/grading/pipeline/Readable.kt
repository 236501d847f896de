package cga.grading.pipeline

import cga.framework.InputError
import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import java.nio.file.attribute.PosixFileAttributes
import java.nio.file.attribute.PosixFilePermission.OTHERS_EXECUTE
import java.nio.file.attribute.PosixFilePermission.OTHERS_READ
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.isDirectory
import kotlin.io.path.name
import kotlin.io.path.setPosixFilePermissions

/** Submissions that the sandbox's user, who is nobody, can read. */
internal object Readable {
    private const val MOST_BYTES = 1L shl 30
    private const val MOST_ENTRIES = 50_000
    private val FILE = PosixFilePermissions.fromString("rw-r--r--")
    private val FOLDER = PosixFilePermissions.fromString("rwxr-xr-x")

    /**
     * The folder [given] where everybody may read all of it, else a copy of its files and folders below [copies]; an archive as it is.
     * Throws [InputError] where it cannot be copied or is too large to be one.
     */
    fun of(
        given: Path,
        copies: Path,
    ): Path {
        if (!given.isDirectory() || isOpen(given)) return given
        val target = copies.resolve(given.toRealPath().name)
        return try {
            Files.walkFileTree(given.toRealPath(), Copy(given.toRealPath(), Files.createDirectories(copies).resolve(target.name)))
            target
        } catch (e: IOException) {
            throw InputError("$given cannot be copied (${e.message}).", e)
        }
    }

    private fun isOpen(folder: Path): Boolean {
        var isOpen = true
        Files.walkFileTree(
            folder.toRealPath(),
            object : SimpleFileVisitor<Path>() {
                override fun preVisitDirectory(path: Path, attributes: BasicFileAttributes) = look(path, setOf(OTHERS_READ, OTHERS_EXECUTE))

                override fun visitFile(path: Path, attributes: BasicFileAttributes) =
                    if (attributes.isRegularFile) look(path, setOf(OTHERS_READ)) else FileVisitResult.CONTINUE

                override fun visitFileFailed(path: Path, e: IOException) = FileVisitResult.CONTINUE

                private fun look(path: Path, needed: Set<Any>): FileVisitResult {
                    isOpen = Files.readAttributes(path, PosixFileAttributes::class.java).permissions().containsAll(needed)
                    return if (isOpen) FileVisitResult.CONTINUE else FileVisitResult.TERMINATE
                }
            },
        )
        return isOpen
    }

    /** Copies plain files and folders; links stay behind. */
    private class Copy(
        private val from: Path,
        private val to: Path,
    ) : SimpleFileVisitor<Path>() {
        private var bytes = 0L
        private var entries = 0

        override fun preVisitDirectory(path: Path, attributes: BasicFileAttributes): FileVisitResult {
            count(0)
            Files.createDirectories(place(path)).setPosixFilePermissions(FOLDER)
            return FileVisitResult.CONTINUE
        }

        override fun visitFile(path: Path, attributes: BasicFileAttributes): FileVisitResult {
            if (!attributes.isRegularFile) return FileVisitResult.CONTINUE
            count(attributes.size())
            Files.copy(path, place(path)).setPosixFilePermissions(FILE)
            return FileVisitResult.CONTINUE
        }

        private fun place(path: Path) = to.resolve(from.relativize(path).toString())

        private fun count(size: Long) {
            bytes += size
            if (bytes > MOST_BYTES || ++entries > MOST_ENTRIES) {
                throw InputError("$from is larger than ${MOST_BYTES shr 30} GiB or $MOST_ENTRIES files: name the submission's own folder.")
            }
        }
    }
}
