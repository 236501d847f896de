package cga.grading.sandbox

import java.io.IOException
import java.io.InputStream
import java.nio.channels.Channels
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.SecureDirectoryStream
import java.nio.file.StandardOpenOption.READ
import java.nio.file.attribute.BasicFileAttributeView
import java.nio.file.attribute.BasicFileAttributes

/**
 * Goes through a folder that a stranger has filled, in the order of the names, from open folder to open folder: no link is followed and no
 * path is made of what things are called there.
 *
 * @param most entries that are looked at; the rest is left out, and what lies deeper than any honest program goes.
 */
internal class OpenFolders(
    private val most: Int,
) {
    private var entries = 0

    /** Something in a folder: where it lies, what it is, null where that cannot be told, and its bytes where it is a plain file. */
    class Entry(
        val name: String,
        val attributes: BasicFileAttributes?,
        val open: () -> InputStream,
    )

    /** Has [visit] look at all below [folder] but for folders that are called as one of [without]. */
    fun walk(folder: Path, without: Set<String> = emptySet(), visit: (Entry) -> Unit) {
        Files.newDirectoryStream(folder).use { stream ->
            // Not so only on systems that have no sandbox either.
            if (stream !is SecureDirectoryStream<Path>) throw IOException("folders cannot be gone through by descriptors here")
            walk(stream, "", 0, without, visit)
        }
    }

    private fun walk(stream: SecureDirectoryStream<Path>, prefix: String, depth: Int, without: Set<String>, visit: (Entry) -> Unit) {
        val names = stream.asSequence().map { it.fileName }.take(most - entries).sortedBy { "$it" }.toList()
        entries += names.size
        for (name in names) {
            val attributes = attributes(stream, name)
            if (attributes?.isDirectory != true) {
                visit(
                    Entry("$prefix$name", attributes) { Channels.newInputStream(stream.newByteChannel(name, setOf(READ, NOFOLLOW_LINKS))) },
                )
            } else if ("$name" !in without && depth < DEEPEST) {
                try {
                    stream.newDirectoryStream(name, NOFOLLOW_LINKS).use { walk(it, "$prefix$name/", depth + 1, without, visit) }
                } catch (_: IOException) {
                    // What cannot be entered is part of it by its name.
                    visit(Entry("$prefix$name", null) { InputStream.nullInputStream() })
                }
            }
        }
    }

    private fun attributes(stream: SecureDirectoryStream<Path>, name: Path): BasicFileAttributes? =
        try {
            stream.getFileAttributeView(name, BasicFileAttributeView::class.java, NOFOLLOW_LINKS).readAttributes()
        } catch (_: IOException) {
            null
        }

    private companion object {
        const val DEEPEST = 64
    }
}
