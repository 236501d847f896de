package cga.framework.image

import cga.framework.AtomicFile
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * Writes animated PNG (APNG, PNG third edition, section 11.3.6): what shows PNG shows the first picture, every browser all of them, without loss.
 */
public object ApngFile {
    /** What the names of such files end with. */
    public const val SUFFIX: String = ".apng"

    // Delays are fractions of two 16-bit numbers.
    private const val DELAY = 100
    private const val MAX_FPS = 655.0

    /**
     * Writes an animation of [frames] pictures, [fps] a second, that plays for ever, to [target], whole or not at all.
     *
     * @param picture makes picture 0, 1, …, all of one size; asked for one after the other.
     * Throws [cga.framework.InputError] when the file cannot be written, [IllegalArgumentException] when a number is out of range.
     */
    public fun write(
        target: Path,
        frames: Int,
        fps: Double,
        picture: (Int) -> ImageData,
    ) {
        require(frames >= 1) { "$frames pictures: an animation has at least 1" }
        require(fps > 1.0 / DELAY && fps <= MAX_FPS) { "$fps pictures a second: more than ${1.0 / DELAY}, at most $MAX_FPS" }
        AtomicFile.write(target) { temporary ->
            Files.newOutputStream(temporary).buffered().use { Writer(it, frames, fps).write(picture) }
        }
    }

    private class Writer(
        private val file: OutputStream,
        private val frames: Int,
        fps: Double,
    ) {
        private val delay = short(DELAY) + short(Math.round(fps * DELAY).toInt())
        private var sequence = 0

        fun write(picture: (Int) -> ImageData) {
            val first = picture(0)
            PngFile.start(file, first.width, first.height)
            PngFile.chunk(file, "acTL", listOf(PngFile.bytes(frames), PngFile.bytes(0)))
            for (frame in 0 until frames) add(if (frame == 0) first else picture(frame), first, frame == 0)
            PngFile.chunk(file, "IEND", emptyList())
        }

        private fun add(
            image: ImageData,
            first: ImageData,
            isFirst: Boolean,
        ) {
            require(image.width == first.width && image.height == first.height) {
                "a picture of ${image.width}x${image.height} in an animation of ${first.width}x${first.height}"
            }
            val place = listOf(image.width, image.height, 0, 0).map(PngFile::bytes)
            // Not disposed of, not blended: every picture covers the one before.
            PngFile.chunk(file, "fcTL", listOf(next()) + place + listOf(delay, byteArrayOf(0, 0)))
            PngFile.pixels(image) {
                if (isFirst) PngFile.chunk(file, "IDAT", it) else PngFile.chunk(file, "fdAT", listOf(next()) + it)
            }
        }

        private fun next() = PngFile.bytes(sequence++)

        private fun short(number: Int) = byteArrayOf((number shr 8).toByte(), number.toByte())
    }
}
