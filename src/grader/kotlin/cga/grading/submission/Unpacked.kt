package cga.grading.submission

import java.io.FilterInputStream
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.util.Locale

/** What an archive's entry is; only files and folders are unpacked. */
internal enum class EntryKind { FILE, FOLDER, LINK, DEVICE }

/** The folder that an archive of [archiveBytes] is unpacked to, and what may be written there. */
internal class Unpacked(
    private val folder: Path,
    private val archiveBytes: Long,
) {
    val notes = mutableListOf<String>()
    private val seen = HashSet<String>()
    private var entries = 0
    private var bytes = 0L
    private var skipped = 0

    /** Writes one entry, or skips it with a note. Throws [BadArchive] when the archive as a whole asks for too much. */
    fun add(name: String, kind: EntryKind, content: InputStream) {
        if (++entries > MOST_ENTRIES) throw BadArchive("the archive has more than $MOST_ENTRIES entries. Hand in the project only.")
        val parts = name.replace('\\', '/').split('/').filter { it.isNotEmpty() && it != "." }
        val fault = fault(name, parts, kind)
        when {
            parts.isEmpty() || parts.any { it in UNWANTED } -> Unit
            fault != null -> skip(name, fault)
            kind == EntryKind.FOLDER -> attempt(name) { Files.createDirectories(place(parts)) }
            else -> attempt(name) {
                Files.createDirectories(place(parts).parent)
                Files.newOutputStream(place(parts), CREATE_NEW).use { content.transferTo(it) }
            }
        }
    }

    private fun place(parts: List<String>) = parts.fold(folder, Path::resolve)

    private fun fault(name: String, parts: List<String>, kind: EntryKind): String? =
        when {
            kind == EntryKind.LINK -> "it is a link"
            kind == EntryKind.DEVICE -> "it is a device or a pipe"
            name.startsWith('/') || name.startsWith('\\') || name.getOrNull(1) == ':' -> "its path is absolute"
            ".." in parts -> "its path leads out of the archive"
            name.any { it.code < ' '.code || it.code == DELETE } -> "its name has control characters"
            parts.any { it.toByteArray().size > LONGEST_NAME } || name.length > LONGEST_PATH -> "its name is too long"
            // Case aside: the course's machines cannot keep two such files either.
            kind == EntryKind.FILE && !seen.add(parts.joinToString("/").lowercase(Locale.ROOT)) -> "there is another of that name"
            else -> null
        }

    private fun attempt(name: String, action: () -> Unit) =
        try {
            action()
        } catch (e: IOException) {
            Room.require(folder, e)
            skip(name, "it cannot be written: ${e.message}")
        }

    /** [stream], with what is read of it counted. Throws [BadArchive] while it is read when that is too much. */
    fun counted(stream: InputStream): InputStream =
        object : FilterInputStream(stream) {
            override fun read(): Int = ByteArray(1).let { if (read(it, 0, 1) < 0) -1 else it[0].toInt() and 0xff }

            override fun read(buffer: ByteArray, offset: Int, length: Int): Int =
                super.read(buffer, offset, length).also { if (it > 0) count(it) }

            // What would be skipped unread would not be counted.
            override fun skip(length: Long): Long = read(ByteArray(minOf(length, BUFFER.toLong()).toInt())).coerceAtLeast(0).toLong()
        }

    private fun count(read: Int) {
        bytes += read
        if (bytes > MOST_BYTES) throw BadArchive("the archive unpacks to more than ${MOST_BYTES shr 20} MiB. Hand in the project only.")
        if (bytes > FREE_BYTES && bytes / archiveBytes.coerceAtLeast(1) > MOST_RATIO) {
            throw BadArchive("the archive unpacks to more than $MOST_RATIO times its size: that is no project.")
        }
    }

    private fun skip(name: String, why: String) {
        if (++skipped <= MOST_NOTES) notes += "${name.take(NOTED_LENGTH)} was not unpacked: $why."
        if (skipped == MOST_NOTES + 1) notes += "More entries of the archive were not unpacked."
    }

    private companion object {
        const val MOST_ENTRIES = 20_000
        const val MOST_BYTES = 512L shl 20

        /** Small archives of text shrink a lot; a bomb shows only in large ones. */
        const val FREE_BYTES = 32L shl 20
        const val MOST_RATIO = 100
        const val LONGEST_NAME = 255
        const val LONGEST_PATH = 1000
        const val MOST_NOTES = 10
        const val NOTED_LENGTH = 100
        const val BUFFER = 1 shl 16
        const val DELETE = 0x7f
        val UNWANTED = setOf("__MACOSX", ".DS_Store", ".git", ".gradle")
    }
}
