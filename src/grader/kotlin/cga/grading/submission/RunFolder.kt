package cga.grading.submission

import java.io.IOException
import java.nio.file.FileVisitOption
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeBytes

/**
 * The folder that a submission is started in: a copy of its own, without links, and with files of ours for models and textures that it names
 * and does not bring along. A name that differs only in upper and lower case from that of a file that is there means this file, as it did on
 * the student's computer.
 *
 * @param folder where it is made.
 */
internal class RunFolder(
    private val submission: Submission,
    private val folder: Path,
) {
    /** What was missing or left out, in full sentences. */
    val notes = mutableListOf<String>()

    init {
        Copy().run()
        val queue = ArrayDeque(NamedFiles.inSources(submission.sources).map { it to null as Path? })
        val seen = HashSet<String>()
        var missing = 0
        while (queue.isNotEmpty() && missing < MOST_MISSING) {
            val (name, user) = queue.removeFirst()
            if (!seen.add(name)) continue
            val noted = notes.size
            val file = try {
                provide(name, user)
            } catch (e: IOException) {
                // A file of the submission's lies where a folder would have to be.
                Room.require(folder, e)
                null
            }
            missing += notes.size - noted
            if (file == null) continue
            NamedFiles.inModel(file, name).forEach { queue.add(it to file) }
        }
    }

    /** The file that [name] means, if need be one of ours; null where there is none. The file [user] names it, or a source where that is null. */
    private fun provide(name: String, user: Path?): Path? {
        val path = folder.resolve(name)
        if (path.exists()) return path.takeIf { it.isRegularFile() }
        val alike = alike(name.split('/'))
        if (alike != null) {
            clone(folder.resolve(alike), path)
            notes += "$name is meant to be $alike: upper and lower case differ."
        } else if (NamedFiles.isReplaceable(name) && !isElsewhere(name)) {
            StandInAssets.of(name, user?.let(NamedFiles::materials).orEmpty()).forEach(::put)
            notes += "$name is missing: a file of ours stands in for it."
        }
        return path.takeIf { it.isRegularFile() }
    }

    private fun put(name: String, content: ByteArray) {
        val at = folder.resolve(alike(name.split('/').dropLast(1)) ?: name.substringBeforeLast('/')).resolve(name.substringAfterLast('/'))
        val file = folder.resolve(name)
        if (!at.exists()) at.createParentDirectories().writeBytes(content)
        if (!file.exists()) clone(at, file)
    }

    /** What is called [parts] but for upper and lower case, by its own name. */
    private fun alike(parts: List<String>): String? =
        parts.fold<String, Path?>(folder) { at, part -> at?.takeIf { it.isDirectory() }?.let { child(it, part) } }?.let {
            folder.relativize(it).joinToString("/")
        }

    private fun child(of: Path, name: String): Path? =
        of.resolve(name).takeIf { it.exists() } ?: of.listDirectoryEntries().firstOrNull { it.name.equals(name, ignoreCase = true) }

    /** Has [file] by the name [other] too, and beside it all that lies beside [file]. */
    private fun clone(file: Path, other: Path) {
        if (other.parent != file.parent) {
            other.parent.createDirectories()
            for (path in file.parent.listDirectoryEntries().filter { it.isRegularFile() }) link(path, other.resolveSibling(path.name))
        }
        link(file, other)
    }

    private fun link(file: Path, other: Path) {
        if (!other.exists()) Files.createLink(other, file)
    }

    /** Whether the sources put a folder before [name]. */
    private fun isElsewhere(name: String): Boolean {
        if (submission.workingDirectory.resolve(name.substringBefore('/')).exists()) return false
        return submission.tree.files.any { "/${submission.tree.name(it)}".endsWith("/$name", ignoreCase = true) }
    }

    /** Copies the submission's own. Of links those within the submission mean what they lead to; all others stay behind. */
    private inner class Copy : SimpleFileVisitor<Path>() {
        private val from = submission.workingDirectory
        private val first = from.resolve("assets")
        private var bytes = 0L
        private var entries = 0

        /** What a program of the course reads comes first, while there is room. */
        fun run() {
            folder.createDirectories()
            for (start in listOf(first, from)) Files.walkFileTree(start, setOf(FileVisitOption.FOLLOW_LINKS), DEEPEST, this)
        }

        // Folders without files are not made: they would take the room of files.
        override fun preVisitDirectory(path: Path, attributes: BasicFileAttributes): FileVisitResult {
            val isDone = path == first && place(path).exists()
            return if (isDone || path.name in FileTree.TOOLS || !isInside(path)) FileVisitResult.SKIP_SUBTREE else FileVisitResult.CONTINUE
        }

        override fun visitFile(path: Path, attributes: BasicFileAttributes): FileVisitResult {
            val target = place(path)
            if (!attributes.isRegularFile || target.exists() || !isInside(path)) return FileVisitResult.CONTINUE
            if (bytes + attributes.size() > MOST_BYTES || ++entries > MOST_ENTRIES) {
                if (notes.size <
                    MOST_LEFT_OUT
                ) {
                    notes += "${submission.tree.name(path)} was left out: all files together are too large or too many."
                }
                return FileVisitResult.CONTINUE
            }
            bytes += attributes.size()
            try {
                Files.copy(path, target.createParentDirectories())
            } catch (e: IOException) {
                Unreadable.require(e)
                Room.require(folder, e)
            }
            return FileVisitResult.CONTINUE
        }

        override fun visitFileFailed(path: Path, e: IOException): FileVisitResult {
            Unreadable.require(e)
            return FileVisitResult.CONTINUE
        }

        override fun postVisitDirectory(path: Path, e: IOException?) = FileVisitResult.CONTINUE

        private fun place(path: Path) = folder.resolve(from.relativize(path).toString())

        private fun isInside(path: Path) = path.toRealPath().startsWith(submission.root)
    }

    private companion object {
        const val MOST_MISSING = 20
        const val MOST_LEFT_OUT = 10
        const val MOST_BYTES = 512L shl 20
        const val MOST_ENTRIES = 20_000
        const val DEEPEST = 24
    }
}
