package cga.imaging

import cga.framework.Home
import cga.framework.InputError
import cga.imaging.file.ExrHeader
import cga.imaging.file.ExrReader
import cga.imaging.file.ForeignFormat
import cga.imaging.file.MAX_PIXELS
import cga.imaging.file.PngChunks
import cga.imaging.file.PngReader
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.fileSize

/** Reads pictures to compare: PNG and OpenEXR, told apart by their content. */
public object PictureFile {
    // The largest picture takes 16 bytes a pixel, uncompressed as OpenEXR; a quarter more for all that may stand around it.
    private const val MAX_BYTES = 20 * MAX_PIXELS

    /**
     * The picture in [file], every value as it was stored: gamma and colour profiles are not applied, grey and palettes become the
     * colours that they mean. Throws [InputError] naming the file and what is wrong with it.
     */
    public fun read(file: Path): Picture {
        checkSize(file)
        val bytes = Home.read(file, "picture")
        return try {
            decode(bytes)
        } catch (e: InputError) {
            throw InputError("picture file $file: ${e.message}", e)
        }
    }

    private fun checkSize(file: Path) {
        if (!Files.isRegularFile(file)) return
        if (file.fileSize() >
            MAX_BYTES
        ) {
            throw InputError("picture file $file is larger than ${MAX_BYTES shr 20} MiB: make the picture smaller.")
        }
    }

    /** The picture in the content of a file. Throws [InputError] with what is wrong. */
    internal fun decode(file: ByteArray): Picture =
        when {
            file.isEmpty() -> throw InputError("it is empty: save it again.")
            file.startsWith(PngChunks.SIGNATURE) -> PngReader.read(file)
            file.startsWith(ExrHeader.MAGIC) -> ExrReader.read(file)
            file.isCutOff() -> throw InputError("it is cut off after ${file.size} bytes: save it again.")
            else -> throw InputError(
                "it is ${ForeignFormat.of(file) ?: "neither PNG nor OpenEXR"}: save it as PNG, or as OpenEXR for floats.",
            )
        }

    private fun ByteArray.startsWith(start: ByteArray): Boolean = size >= start.size && start.indices.all { this[it] == start[it] }

    /** Whether there is nothing but the beginning of a signature. */
    private fun ByteArray.isCutOff(): Boolean = listOf(PngChunks.SIGNATURE, ExrHeader.MAGIC).any { it.startsWith(this) }
}
