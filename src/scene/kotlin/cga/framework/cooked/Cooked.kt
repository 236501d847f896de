package cga.framework.cooked

import cga.framework.AtomicFile
import cga.framework.InputError
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32

/**
 * What is slow to make of source files, kept for the next start: models parsed, pictures decoded.
 *
 * Kept in the folder that the system property `cga.cooked` names (the launcher does), and nowhere without it. A cooked file counts only
 * while every source has the bytes it was made of; a damaged or an outdated one is made again. Whatever goes wrong in keeping, the
 * program goes on from the sources.
 */
internal object Cooked {
    private val folder: Path? = System.getProperty("cga.cooked")?.let(Path::of)

    /**
     * What [decode] makes of the cooked form of [source], or null when there is none. [form] tells several forms of one source apart.
     * The buffer is little-endian, at its start, and may not be kept.
     */
    fun <T> read(
        source: Path,
        form: String,
        decode: (ByteBuffer) -> T,
    ): T? = folder?.let { read(it, source, form, decode) }

    fun <T> read(
        folder: Path,
        source: Path,
        form: String,
        decode: (ByteBuffer) -> T,
    ): T? {
        val cooked = CookedFile.read(fileFor(folder, source, form)) ?: return null
        // Two paths may have one name here; which it was the file knows.
        val isOf = cooked.sources.firstOrNull()?.path == "$source"
        return if (isOf && cooked.sources.all(::isUnchanged)) decode(cooked.payload) else null
    }

    /**
     * Answers what [make] makes of the files [sources], the first of which names it, and keeps what [encode] makes of that (nothing, when
     * null), unless a source changed meanwhile.
     */
    fun <T : Any> make(
        sources: List<Path>,
        form: String,
        encode: (T) -> ByteBuffer,
        make: () -> T,
    ): T = if (folder == null) make() else make(folder, sources, form, encode, make)

    fun <T : Any> make(
        folder: Path,
        sources: List<Path>,
        form: String,
        encode: (T) -> ByteBuffer,
        make: () -> T,
    ): T {
        val file = fileFor(folder, sources.first(), form)
        val before = fingerprints(sources)
        val made = make()
        if (before != null && before == fingerprints(sources)) keep(CookedFile(before, encode(made)), file)
        return made
    }

    /** Where the cooked form of [source] lies: told apart by its whole path, named for people. */
    fun fileFor(
        folder: Path,
        source: Path,
        form: String,
    ): Path {
        val path = "$source".toByteArray()
        val number = Integer.toHexString(CRC32().apply { update(path) }.value.toInt())
        return folder.resolve("${source.fileName}-$number.$form")
    }

    private fun isUnchanged(source: CookedFile.Fingerprint): Boolean =
        try {
            CookedFile.Fingerprint.of(Path.of(source.path)) == source
        } catch (_: IOException) {
            false
        }

    /** Null when one cannot be read: [make] will say so better. */
    private fun fingerprints(sources: List<Path>): List<CookedFile.Fingerprint>? =
        try {
            sources.map(CookedFile.Fingerprint::of)
        } catch (_: IOException) {
            null
        }

    private fun keep(
        cooked: CookedFile,
        file: Path,
    ) {
        try {
            Files.createDirectories(file.parent)
            AtomicFile.write(file, cooked::write)
        } catch (_: IOException) {
            // A read-only checkout starts as it did before there was anything cooked.
        } catch (_: InputError) {
            // Likewise: the folder cannot be written.
        }
    }
}
