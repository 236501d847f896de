package cga.grading.pipeline

import cga.grading.submission.FileTree
import cga.grading.submission.NamedFiles
import cga.grading.submission.StandInAssets
import cga.grading.submission.Submission
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeBytes

/**
 * The folder that a submission is started in. Where models or textures that it names are missing, that is a folder of links to its own
 * files, with ours for those that are missing; what was handed in is not touched. A name that differs only in upper and lower case from
 * that of a file that is there means this file, as it did on the student's computer.
 *
 * @param links where the folder of links is made, if need be.
 */
internal class RunFolder(private val submission: Submission, links: Path) {
    private val links = links.toAbsolutePath().parent.toRealPath().resolve(links.name)
    private val original = submission.workingDirectory.toRealPath()

    /** Where to start the submission. */
    var folder: Path = original
        private set

    /** What was missing, in full sentences. */
    val notes = mutableListOf<String>()

    init {
        val queue = ArrayDeque(NamedFiles.inSources(submission.sources).map { it to emptyList<String>() })
        val seen = HashSet<String>()
        while (queue.isNotEmpty() && notes.size < MOST_NOTES) {
            val (name, materials) = queue.removeFirst()
            if (!seen.add(name)) continue
            val file = provide(name, materials)?.takeIf(::isInside) ?: continue
            val used = if (name.endsWith(".obj", ignoreCase = true)) NamedFiles.materials(file) else emptyList()
            NamedFiles.inModel(file, name).forEach { queue.add(it to used) }
        }
    }

    /** The file that [name] means, if need be one of ours; null where there is none. */
    private fun provide(name: String, materials: List<String>): Path? {
        folder.resolve(name).let { if (it.exists()) return it }
        val parent = open(name.split('/').dropLast(1), make = false)
        val alike = parent?.let { child(it, name.substringAfterLast('/')) }
        if (alike != null) {
            val path = parent.resolve(name.substringAfterLast('/'))
            if (!path.exists()) path.createSymbolicLinkPointingTo(Path.of(alike.name))
            notes += "$name is meant to be ${original.relativize(alike.toRealPath())}: upper and lower case differ."
        } else if (NamedFiles.isReplaceable(name) && !isElsewhere(name)) {
            StandInAssets.of(name, materials).forEach(::put)
            notes += "$name is missing: a file of ours stands in for it."
        }
        return folder.resolve(name).takeIf { it.exists() }
    }

    private fun put(name: String, content: ByteArray) {
        val file = open(name.split('/').dropLast(1), make = true)?.resolve(name.substringAfterLast('/')) ?: return
        if (!file.exists()) file.writeBytes(content)
    }

    /** The folder of links at [parts], opened so that files can be added; null where it is missing and not to be made. */
    private fun open(parts: List<String>, make: Boolean): Path? {
        if (folder != links) folder = links.also { linkAll(original, it) }
        return parts.fold<String, Path?>(links) { at, part -> at?.let { openChild(it, part, make) } }
    }

    private fun openChild(at: Path, name: String, make: Boolean): Path? {
        val path = at.resolve(name)
        if (!path.exists()) {
            val alike = child(at, name)
            when {
                alike != null -> path.createSymbolicLinkPointingTo(Path.of(alike.name))
                make -> return path.createDirectory()
                else -> return null
            }
        }
        val real = path.toRealPath()
        return when {
            !real.isDirectory() || !isInside(real) -> null
            real.startsWith(links) -> real
            // Beside it may lie a link to it by another name, so it keeps its own.
            else -> {
                val own = if (path.resolveSibling(real.name).isSymbolicLink()) path.resolveSibling(real.name) else path
                own.deleteExisting()
                own.also { linkAll(real, it) }
            }
        }
    }

    private fun linkAll(from: Path, to: Path) {
        to.createDirectory()
        from.listDirectoryEntries().forEach { to.resolve(it.name).createSymbolicLinkPointingTo(it) }
    }

    private fun child(of: Path, name: String): Path? = of.listDirectoryEntries().firstOrNull { it.name.equals(name, ignoreCase = true) }

    /** Whether the sources put a folder before [name]. */
    private fun isElsewhere(name: String): Boolean {
        if (original.resolve(name.substringBefore('/')).exists()) return false
        val tree = FileTree(submission.root)
        return tree.files.any { "/${tree.name(it)}".endsWith("/$name", ignoreCase = true) }
    }

    /** Links of a submission may lead anywhere: nothing is looked for there. */
    private fun isInside(path: Path): Boolean =
        path.toRealPath().let { real -> listOf(submission.root, links).any(real::startsWith) } &&
            (path.isDirectory() || path.isRegularFile())

    private companion object {
        const val MOST_NOTES = 20
    }
}
