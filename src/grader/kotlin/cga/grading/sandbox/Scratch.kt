package cga.grading.sandbox

import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import java.util.concurrent.TimeUnit.SECONDS

/** Folders that a job has filled, and whose contents are therefore anything at all. */
public object Scratch {
    /** Deeper than any honest program goes. A path could grow too long for any call that takes one. */
    private const val DEEPEST = 64
    private const val DELETE_SECONDS = 60L
    private const val BLOCK = 4096L

    /** Removes [folder] and all in it, following no link. A folder that cannot be removed is left. */
    public fun delete(folder: Path) {
        // The system's own tools go down by open folders, so that neither depth nor length of a path stops them.
        for (command in listOf(listOf("chmod", "-R", "u+rwX"), listOf("rm", "-rf", "--one-file-system"))) {
            val process = ProcessBuilder(command + listOf("--", "$folder"))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start()
            if (!process.waitFor(DELETE_SECONDS, SECONDS)) process.destroyForcibly()
            if (!Files.exists(folder, NOFOLLOW_LINKS)) return
        }
    }

    /** Makes [user] the owner of [folder] and all in it, of links themselves and not of what they point to. */
    internal fun giveTo(folder: Path, user: Int) {
        walk(folder) { path, _ ->
            Files.setAttribute(path, "unix:uid", user, NOFOLLOW_LINKS)
            true
        }
    }

    /** Whether [folders] together hold more than [limits] allow; [openBytes] are in deleted files and count too. */
    internal fun isOver(folders: List<Path>, limits: Limits, openBytes: Long): Boolean {
        var bytes = openBytes
        var entries = 0
        var isOver = false
        for (folder in folders) {
            walk(folder) { path, attributes ->
                // A file takes at least what its data does, but a sparse file of 10 GB would be 10 GB for whoever copies it.
                bytes += attributes.size().coerceAtLeast(BLOCK)
                isOver = bytes > limits.diskBytes || ++entries > limits.diskEntries || path.nameCount - folder.nameCount > DEEPEST
                !isOver
            }
            if (isOver) return true
        }
        return false
    }

    private fun walk(folder: Path, visit: (Path, BasicFileAttributes) -> Boolean) {
        Files.walkFileTree(
            folder,
            object : SimpleFileVisitor<Path>() {
                override fun preVisitDirectory(path: Path, attributes: BasicFileAttributes) = visitFile(path, attributes)

                override fun visitFile(path: Path, attributes: BasicFileAttributes) =
                    if (visit(path, attributes)) FileVisitResult.CONTINUE else FileVisitResult.TERMINATE

                // It was deleted meanwhile, or is hidden from us.
                override fun visitFileFailed(path: Path, e: IOException) = FileVisitResult.CONTINUE

                override fun postVisitDirectory(path: Path, e: IOException?) = FileVisitResult.CONTINUE
            },
        )
    }
}
