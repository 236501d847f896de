package cga.grading.submission

import java.io.IOException
import java.io.InputStream
import java.nio.charset.Charset
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import java.util.zip.ZipException
import java.util.zip.ZipFile
import kotlin.io.path.fileSize
import kotlin.io.path.inputStream
import kotlin.io.path.name

/** Archives that are handed in, told by their first bytes and not by their names. */
internal enum class Archive {
    ZIP,
    TAR,
    TAR_GZ,
    ;

    /** Unpacks [file] to [folder], which it makes, and returns notes. Throws [BadArchive] for what cannot or must not be unpacked. */
    fun unpack(file: Path, folder: Path): List<String> {
        Files.createDirectories(folder)
        val unpacked = Unpacked(folder.toAbsolutePath(), file.fileSize())
        try {
            when (this) {
                ZIP -> unzip(file, unpacked)
                TAR -> untar(file.inputStream().buffered(), unpacked)
                TAR_GZ -> untar(GZIPInputStream(file.inputStream().buffered()).buffered(), unpacked)
            }
        } catch (e: IOException) {
            Unreadable.require(e)
            throw BadArchive("${file.name} is not a sound archive (${e.message}). Pack it again.")
        } catch (e: IllegalArgumentException) {
            throw BadArchive("${file.name} is not a sound archive (${e.message}). Pack it again.")
        }
        return unpacked.notes
    }

    /** All of a tar has to be read, also what is skipped: so all of it counts. */
    private fun untar(stream: InputStream, unpacked: Unpacked) =
        unpacked.counted(stream).use { TarReader(it).readAll(unpacked::add) }

    private fun unzip(file: Path, unpacked: Unpacked) {
        val zip = try {
            ZipFile(file.toFile(), Charsets.UTF_8)
        } catch (e: ZipException) {
            // Windows' own packer writes names in the console's code page.
            if ("bad entry name" !in e.message.orEmpty() && "invalid CEN" !in e.message.orEmpty()) throw e
            ZipFile(file.toFile(), codePage())
        }
        zip.use {
            for (entry in zip.entries()) {
                val kind = if (entry.isDirectory) EntryKind.FOLDER else EntryKind.FILE
                // A link in a zip file is a small file with its target in it, and is unpacked as that.
                val content = if (entry.isDirectory) InputStream.nullInputStream() else unpacked.counted(zip.getInputStream(entry))
                content.use { unpacked.add(entry.name, kind, it) }
            }
        }
    }

    private fun codePage(): Charset = if (Charset.isSupported("IBM437")) Charset.forName("IBM437") else Charsets.ISO_8859_1

    companion object {
        private const val ENOUGH = 512
        private const val USTAR_AT = 257

        /** What [file] is, null for no archive at all. Throws [BadArchive] for an archive that cannot be read here. */
        fun of(file: Path): Archive? {
            val head = file.inputStream().use { it.readNBytes(ENOUGH) }.toString(Charsets.ISO_8859_1)
            return when {
                head.startsWith("PK\u0003\u0004") || head.startsWith("PK\u0005\u0006") -> ZIP
                head.startsWith("\u001f\u008b") -> TAR_GZ
                head.startsWith("ustar", USTAR_AT) -> TAR
                head.startsWith("7z\u00bc\u00af") -> throw BadArchive("${file.name} is a 7-Zip archive: pack it as zip or tar.gz.")
                head.startsWith("Rar!") -> throw BadArchive("${file.name} is a RAR archive: pack it as zip or tar.gz.")
                else -> null
            }
        }
    }
}
