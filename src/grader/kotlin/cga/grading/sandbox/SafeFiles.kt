package cga.grading.sandbox

import cga.framework.InputError
import java.io.IOException
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes

/**
 * Reads what a job has left behind. Nothing but plain files: a link would lead the reader to files that the job may not see, a pipe would
 * never end. Only for folders whose writers have all ended, as they have when a [Sandbox] returns.
 */
public object SafeFiles {
    /** The bytes of the file [name] (`/` between folders) below [folder]. Throws [InputError] unless it is a plain file of at most [limit]. */
    public fun read(folder: Path, name: String, limit: Long): ByteArray {
        val file = locate(folder, name)
        return try {
            Files.newInputStream(file, NOFOLLOW_LINKS).use { stream ->
                val bytes = stream.readNBytes(Math.toIntExact(minOf(limit + 1, Int.MAX_VALUE - 8L)))
                if (bytes.size > limit) throw InputError("$name is larger than $limit bytes.")
                bytes
            }
        } catch (e: IOException) {
            throw InputError("$name cannot be read (${e.message}).", e)
        }
    }

    /** Whether there is a plain file [name] below [folder], reached without a link. */
    public fun exists(folder: Path, name: String): Boolean =
        try {
            locate(folder, name)
            true
        } catch (_: InputError) {
            false
        }

    /** Whether [path] is a folder and no link to one. */
    internal fun isFolder(path: Path): Boolean = kind(path)?.isDirectory == true

    /** Names of the plain files directly in [folder], in order, at most [limit]; without those that only a link leads to. */
    public fun list(folder: Path, limit: Int): List<String> {
        if (kind(folder)?.isDirectory != true) return emptyList()
        return Files.newDirectoryStream(folder).use { entries ->
            entries.asSequence().filter { kind(it)?.isRegularFile == true }.map { "${it.fileName}" }.take(limit).toList().sorted()
        }
    }

    private fun locate(folder: Path, name: String): Path {
        val parts = name.split('/')
        if (parts.any { it.isEmpty() || it == "." || it == ".." || '\u0000' in it }) throw InputError("$name is not a file's name.")
        val outer = parts.dropLast(1).fold(folder) { path, part ->
            path.resolve(part).also { if (kind(it)?.isDirectory != true) throw InputError("$name: there is no folder $part.") }
        }
        val file = outer.resolve(parts.last())
        val kind = kind(file) ?: throw InputError("$name was not written.")
        if (!kind.isRegularFile) throw InputError("$name is not a plain file.")
        return file
    }

    private fun kind(path: Path): BasicFileAttributes? =
        try {
            Files.readAttributes(path, BasicFileAttributes::class.java, NOFOLLOW_LINKS)
        } catch (_: IOException) {
            null
        }
}
