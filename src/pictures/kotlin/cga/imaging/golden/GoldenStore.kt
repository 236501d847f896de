package cga.imaging.golden

import cga.framework.InputError
import cga.framework.image.ExrFile
import cga.framework.image.PngFile
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import cga.imaging.PictureFile
import java.nio.file.Files
import java.nio.file.Path
import java.time.LocalDate
import kotlin.io.path.extension
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension

/** An image that somebody looked at and found right, for one case. */
public class Approved internal constructor(
    internal val file: Path,
    public val picture: Picture,
    internal val sidecar: Sidecar,
) {
    /** Where it came from. */
    public val origin: Origin get() = sidecar.origin

    /** Why it was approved. */
    public val reason: String get() = sidecar.reason
}

/**
 * The approved images of cases in [folder]: `CASE.png` (8 bits a channel) or `CASE.exr` (floats) with a sidecar `CASE.json`; further
 * ones of the same case are `CASE~2`, `CASE~3`, ….
 */
public class GoldenStore(private val folder: Path) {
    /** The names of all cases of which the folder holds a file. */
    public fun cases(): Set<String> = files().map { case(it) }.toSortedSet()

    /**
     * The approved images of [case], in the order of their numbers; none where it is missing.
     * Throws [InputError] where an image is without sidecar, a sidecar without image, or one of them is broken.
     */
    public fun approved(case: String): List<Approved> =
        files()
            .filter { case(it) == case }
            .groupBy { it.nameWithoutExtension }
            .toSortedMap(compareBy(::number))
            .values
            .map(::approved)

    private fun approved(files: List<Path>): Approved {
        val (sidecars, pictures) = files.partition { it.extension == SIDECAR }
        val stem = files.first().nameWithoutExtension
        val accept = "delete it, or look at the new picture and then ${acceptCommand(case(files.first()))}"
        val sidecar = sidecars.singleOrNull() ?: throw InputError("golden ${pictures.first()} has no sidecar $stem.json: $accept.")
        if (pictures.isEmpty()) throw InputError("sidecar $sidecar has no image $stem.png or $stem.exr: $accept.")
        val file = pictures.singleOrNull() ?: throw InputError("${pictures.joinToString(" and ")} share a sidecar: delete the wrong one.")
        val approved = Approved(file, opaque(PictureFile.read(file)), Sidecar.read(sidecar))
        if (Checksum.of(approved.picture) != approved.sidecar.picture) {
            throw InputError("golden $file is not the image that its sidecar describes: restore the two as a pair, or $accept.")
        }
        return approved
    }

    /** OpenEXR files of ours always have an alpha channel; in a framebuffer's picture it says nothing. */
    private fun opaque(picture: Picture): Picture =
        when (picture) {
            is BytePicture -> picture
            is FloatPicture -> FloatPicture.opaque(picture.image)
        }

    /**
     * Makes [rendered] the approved image of [case], its only one, or one more of them where [also] is set.
     * Throws [InputError] where a file cannot be written; what is on disk is then told by [approved] as broken, and cured by a second try.
     */
    public fun accept(
        case: String,
        rendered: Rendered,
        reason: String,
        also: Boolean = false,
        date: LocalDate = LocalDate.now(),
    ) {
        require(NAME.matches(case)) { "$case is no name of a case: use small letters, digits, dots and hyphens" }
        val old = files().filter { case(it) == case }
        val number = if (also) (old.maxOfOrNull { number(it.nameWithoutExtension) } ?: 0) + 1 else 1
        val stem = if (number == 1) case else "$case~$number"
        // The image first: until its sidecar follows, the old one's checksum does not fit it, or it has none.
        val picture = write(rendered.picture, stem)
        val sidecar = folder.resolve("$stem.$SIDECAR")
        Sidecar(rendered.origin, Checksum.of(rendered.picture), reason, date).write(sidecar)
        if (!also) old.filter { it != picture && it != sidecar }.forEach(Files::delete)
    }

    private fun write(
        picture: Picture,
        stem: String,
    ): Path =
        when (picture) {
            is BytePicture -> folder.resolve("$stem.png").also { PngFile.write(picture.image, it) }
            is FloatPicture -> folder.resolve("$stem.exr").also { ExrFile.write(picture.image, it) }
        }

    private fun files(): List<Path> {
        if (!Files.isDirectory(folder)) throw InputError("the goldens' folder $folder does not exist: restore it, or create it.")
        return folder.listDirectoryEntries().filter {
            it.isRegularFile() && it.name != TOLERANCE && it.extension in KINDS &&
                !Files.isHidden(it)
        }
    }

    public companion object {
        /** The file beside the goldens that says how far a picture may be from its own. */
        public const val TOLERANCE: String = "tolerance.json"
        private const val SIDECAR = "json"
        private val KINDS = setOf("png", "exr", SIDECAR)
        private val NAME = Regex("""[a-z0-9][a-z0-9.-]*""")

        /** What to type to approve the picture of [case]. */
        internal fun acceptCommand(case: String) = "./cga golden accept $case --reason \"…\""

        private fun case(file: Path) = file.nameWithoutExtension.substringBefore('~')

        private fun number(stem: String) = stem.substringAfter('~', "1").toIntOrNull() ?: Int.MAX_VALUE
    }
}
