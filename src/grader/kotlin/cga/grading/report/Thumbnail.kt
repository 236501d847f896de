package cga.grading.report

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.framework.image.ImageData
import cga.grading.findings.Findings
import cga.grading.findings.Mistake
import cga.imaging.BytePicture
import cga.imaging.PictureFile
import cga.imaging.report.Shrink
import cga.imaging.report.SmallPng
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import kotlin.io.path.deleteIfExists
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes

/** The small picture of a submission on the contact sheet, made when it has been graded so that the sheet need not read large ones. */
public object Thumbnail {
    private const val NAME = "thumbnail.png"
    private const val MOST_WIDTH = 200
    private const val MOST_BYTES = 200_000L

    // So few shades that it packs well; a sheet carries hundreds.
    private const val SHADE_BITS = 0xF8

    /**
     * Writes the thumbnail of the picture that [findings] show of all into [folder], or none where there is no readable picture that is the
     * submission's own.
     */
    public fun write(findings: Findings, folder: Path) {
        val file = folder.resolve(NAME)
        val evidence = findings.pictures.find { it.check == null } ?: findings.pictures.firstOrNull()
        val isOwn = findings.mistakes.none { it.mistake == Mistake.KOTLIN_REFUSED }
        val picture = evidence?.takeIf { isOwn }?.let { read(folder.resolve(it.measured)) }
        if (picture == null) {
            file.deleteIfExists()
            return
        }
        val small = generateSequence(picture) { Shrink.MEAN.halve(it) }.first { it.width <= MOST_WIDTH }
        val rgba = ByteArray(small.rgba.size) { (small.rgba[it].toInt() and SHADE_BITS).toByte() }
        AtomicFile.write(file) { it.writeBytes(SmallPng.encode(ImageData(small.width, small.height, rgba))) }
    }

    /** The thumbnail in [folder] as an address that carries it; null where there is none. */
    internal fun url(folder: Path): String? {
        val file = folder.resolve(NAME)
        if (!Files.isRegularFile(file) || Files.size(file) > MOST_BYTES) return null
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(file.readBytes())
    }

    private fun read(file: Path): ImageData? =
        try {
            (PictureFile.read(file) as? BytePicture)?.image
        } catch (_: InputError) {
            null
        }
}
