package cga.grading.course

import cga.grading.sandbox.OpenFolders
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import java.security.MessageDigest
import kotlin.io.path.inputStream
import kotlin.io.path.isDirectory

/**
 * What a submission consists of, as one number: names and contents of its files, as far as a grader reads. Links, pipes and devices count by
 * being there: nothing in a submission can make this read without end or leave it.
 */
internal object InputChecksum {
    private const val BUFFER = 1 shl 16
    private const val MOST_ENTRIES = 100_000

    /** Of what is larger than what is left of it only the size counts: it is no project, or not the part of one that is graded. */
    private const val MOST_BYTES = 1L shl 30

    /** The checksum of [path] graded with [settings]; "missing" where there is nothing that can be read. */
    fun of(path: Path, settings: String): String =
        try {
            Sum(settings).run {
                val real = path.toRealPath()
                if (real.isDirectory()) {
                    OpenFolders(MOST_ENTRIES).walk(real, setOf(".git")) { add(it.name, it.attributes, it.open) }
                } else {
                    add("", Files.readAttributes(real, BasicFileAttributes::class.java)) { real.inputStream() }
                }
                hex(digest.digest())
            }
        } catch (_: IOException) {
            "missing"
        }

    private class Sum(settings: String) {
        val digest: MessageDigest = MessageDigest.getInstance("SHA-256").apply { update("$settings\n".toByteArray()) }
        private var left = MOST_BYTES

        fun add(name: String, attributes: BasicFileAttributes?, open: () -> java.io.InputStream) {
            val kind = when {
                attributes == null -> "unreadable"
                attributes.isRegularFile -> "file ${attributes.size()}"
                attributes.isSymbolicLink -> "link"
                else -> "other"
            }
            // Lengths before contents: no file can look like the end of one and the beginning of the next.
            digest.update("${name.length} $name $kind\n".toByteArray())
            val size = attributes?.takeIf { it.isRegularFile }?.size() ?: return
            if (size > left) return
            left -= size
            try {
                open().use { stream ->
                    val buffer = ByteArray(BUFFER)
                    generateSequence { stream.read(buffer).takeIf { it >= 0 } }.forEach { digest.update(buffer, 0, it) }
                }
            } catch (_: IOException) {
                digest.update("unreadable\n".toByteArray())
            }
        }
    }
}
