package cga.grading.submission

import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.name

/** The files and folders below [root] that may matter: no links, nothing that builds and tools leave behind. */
internal class FileTree(
    val root: Path,
) {
    val files: List<Path>
    val folders: List<Path>

    init {
        val foundFiles = mutableListOf<Path>()
        val foundFolders = mutableListOf<Path>()
        Files.walkFileTree(
            root,
            setOf(),
            DEEPEST,
            object : SimpleFileVisitor<Path>() {
                override fun preVisitDirectory(folder: Path, attributes: BasicFileAttributes): FileVisitResult {
                    if (folder != root && isLeftOver(folder)) return FileVisitResult.SKIP_SUBTREE
                    foundFolders.add(folder)
                    return FileVisitResult.CONTINUE
                }

                override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
                    if (attributes.isRegularFile) foundFiles.add(file)
                    if (foundFiles.size >
                        MOST_FILES
                    ) {
                        throw NotASubmission("$root has more than $MOST_FILES files: name the submission's own folder.")
                    }
                    return FileVisitResult.CONTINUE
                }

                override fun visitFileFailed(file: Path, e: IOException): FileVisitResult {
                    Unreadable.require(e)
                    return FileVisitResult.CONTINUE
                }
            },
        )
        files = foundFiles.sorted()
        folders = foundFolders.sorted()
    }

    /** How [path] is called below the root. */
    fun name(path: Path): String = root.relativize(path).joinToString("/")

    /** The text of [file], null where it is too large to be one. */
    fun text(file: Path): String? =
        try {
            val bytes = Files.newInputStream(file).use { it.readNBytes(LARGEST_TEXT + 1) }
            if (bytes.size > LARGEST_TEXT) null else bytes.decodeToString().removePrefix("\uFEFF")
        } catch (e: IOException) {
            Unreadable.require(e)
            null
        }

    private fun isLeftOver(folder: Path) = folder.name in LEFT_OVER || (folder.name == "test" && folder.parent.name == "src")

    companion object {
        private const val DEEPEST = 24
        private const val MOST_FILES = 50_000
        private const val LARGEST_TEXT = 1 shl 20

        /** Folders that no program of the course looks into. */
        val TOOLS = setOf(".gradle", ".git", ".kotlin", "__MACOSX", "node_modules")
        private val LEFT_OVER = TOOLS + setOf("build", "out", "target", "bin", "androidTest")
    }
}
