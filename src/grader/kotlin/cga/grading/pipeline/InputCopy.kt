package cga.grading.pipeline

import cga.grading.findings.FailureReason
import cga.grading.sandbox.OpenFolders
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import java.util.zip.Deflater
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.fileSize
import kotlin.io.path.inputStream
import kotlin.io.path.isDirectory
import kotlin.io.path.outputStream
import kotlin.io.path.setPosixFilePermissions

/** Copies for the sandbox's user, who is nobody, of what only its owner may read. Names are data in them and no paths. */
internal object InputCopy {
    private const val MOST_BYTES = 448L shl 20
    private const val MOST_ENTRIES = 19_000

    // Tools' own, which may be larger than all the rest.
    private val TOOLS = setOf(".git", ".gradle", ".kotlin", "__MACOSX", "node_modules")

    /** Copies [given] to [target]: a folder as an archive of its plain files, as far as an archive may go, a file as it is. */
    fun write(given: Path, target: Path) {
        target.outputStream().use { out ->
            if (given.isDirectory()) zip(given, ZipOutputStream(out)) else copy(given, out)
        }
        target.setPosixFilePermissions(PosixFilePermissions.fromString("rw-r--r--"))
    }

    private fun copy(file: Path, out: OutputStream) {
        if (file.fileSize() > MOST_BYTES) throw Stopped(FailureReason.UNPACK_REFUSED, "It is larger than ${MOST_BYTES shr 20} MiB.")
        file.inputStream().use { it.transferTo(out) }
    }

    private fun zip(folder: Path, zip: ZipOutputStream) {
        var left = MOST_BYTES
        // Packed tightly, much of nothing would look like a bomb.
        zip.setLevel(Deflater.NO_COMPRESSION)
        OpenFolders(MOST_ENTRIES).walk(folder, TOOLS) { entry ->
            val size = entry.attributes?.takeIf { it.isRegularFile }?.size() ?: return@walk
            if (size > left) return@walk
            left -= size
            opened(entry)?.use {
                zip.putNextEntry(ZipEntry(entry.name))
                it.transferTo(zip)
            }
        }
        zip.finish()
    }

    /** What nobody may read is left out. */
    private fun opened(entry: OpenFolders.Entry): InputStream? =
        try {
            entry.open()
        } catch (_: IOException) {
            null
        }
}
