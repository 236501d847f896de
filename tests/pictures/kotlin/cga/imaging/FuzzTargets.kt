package cga.imaging

import cga.framework.InputError
import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.imaging.file.ExrBytes
import cga.imaging.file.ExrHeader
import cga.imaging.file.PngBytes
import cga.imaging.file.PngChunks
import java.nio.ByteBuffer
import java.util.zip.CRC32
import kotlin.math.abs

// What tests/fuzz/run.sh throws bytes at: each fails with an exception for an input that breaks the contract.

/** Any bytes are a picture or an [InputError] of one line, as they are and made a little more like PNG. */
internal object PngFuzz {
    @JvmStatic
    fun fuzzerTestOneInput(data: ByteArray) {
        readOrRefuse(data)
        readOrRefuse(withSums(data))
        if (data.size >= HEADER) readOrRefuse(picture(data))
    }

    private const val HEADER = 8

    /** [data] with the checksum of each chunk put right: no random bytes would get past them. */
    private fun withSums(data: ByteArray): ByteArray {
        val file = data.copyOf()
        PngChunks.SIGNATURE.copyInto(file, 0, 0, minOf(file.size, PngChunks.SIGNATURE.size))
        var at = PngChunks.SIGNATURE.size
        while (at + 12 <= file.size) {
            val length = ByteBuffer.wrap(file).getInt(at)
            if (length < 0 || length > file.size - at - 12) break
            val sum = CRC32().apply { update(file, at + 4, 4 + length) }.value.toInt()
            ByteBuffer.wrap(file).putInt(at + 8 + length, sum)
            at += 12 + length
        }
        return file
    }

    /** A file with sound chunks: the first bytes are its header and how much is palette and transparency, the others the rows. */
    private fun picture(data: ByteArray): ByteArray {
        val header = PngBytes.header(data[0].toInt(), data[1].toInt(), data[2].toInt(), data[3].toInt(), interlace = data[4].toInt())
        val paletteEnd = minOf(data.size, HEADER + (data[5].toInt() and 0xFF))
        val transparencyEnd = minOf(data.size, paletteEnd + (data[6].toInt() and 0xFF))
        val palette = PngBytes.chunk("PLTE", data.copyOfRange(HEADER, paletteEnd))
        val transparency = PngBytes.chunk("tRNS", data.copyOfRange(paletteEnd, transparencyEnd))
        val between = listOf(palette, transparency).filter { it.size > 12 }
        return PngBytes.picture(header, data.copyOfRange(transparencyEnd, data.size), *between.toTypedArray())
    }
}

/** The same for OpenEXR. */
internal object ExrFuzz {
    @JvmStatic
    fun fuzzerTestOneInput(data: ByteArray) {
        readOrRefuse(data)
        readOrRefuse(ExrHeader.MAGIC + data)
        if (data.size >= 6) readOrRefuse(picture(data))
    }

    /** A file with a sound header of the kind that the first bytes choose; the others are its blocks. */
    private fun picture(data: ByteArray): ByteArray {
        val exr = ExrBytes(data[0].toInt(), data[1].toInt())
        val type = data[2].toInt()
        exr.channels = listOf(listOf("Y"), listOf("B", "G", "R"), listOf("A", "B", "G", "R"))[data[3].mod(3)].map { it to type }
        exr.compression = data[4].toInt()
        val block = (data[5].toInt() and 0xFF) + 1
        val blocks = data.drop(6).chunked(block) { it.toByteArray() }
        return exr.of(*blocks.map { if (exr.compression >= 2) ExrBytes.zipped(it) else it }.toTypedArray())
    }
}

/** Any two pictures are compared as the definitions have it, or refused with an [InputError]. */
internal object CompareFuzz {
    @JvmStatic
    fun fuzzerTestOneInput(data: ByteArray) {
        if (data.size < 8) return
        val content = data.copyOfRange(6, data.size)
        val expected = picture(data[0], data[1], data[2], content) ?: return
        val actual = picture(data[0], data[1], data[3], changed(content, data[4])) ?: return
        val size = data[5].toInt()
        try {
            check(expected, actual, Difference.between(expected, actual))
            if (size > 0) check(expected, actual, Window.worst(expected, actual, size))
        } catch (e: InputError) {
            checkMessage(e)
            check(expected::class != actual::class || expected.hasAlpha != actual.hasAlpha) { "comparable, but $e" }
        }
    }

    /** The second picture's content: the first's, with every [step]-th byte changed. */
    private fun changed(
        content: ByteArray,
        step: Byte,
    ): ByteArray = ByteArray(content.size) { i -> if (step > 0 && i % step == 0) (content[i] * 7 + i).toByte() else content[i] }

    /** Null where the values are not finite, which is refused. */
    private fun picture(
        width: Byte,
        height: Byte,
        kind: Byte,
        content: ByteArray,
    ): Picture? {
        val (columns, rows) = (width.mod(20) + 1) to (height.mod(20) + 1)
        val bytes = ByteArray(16 * columns * rows) { content[it % content.size] }
        val hasAlpha = kind.mod(2) == 1
        if (kind.mod(4) < 2) return BytePicture(ImageData(columns, rows, bytes.copyOf(4 * columns * rows)), hasAlpha)
        val floats = FloatArray(4 * columns * rows) { ByteBuffer.wrap(bytes).getFloat(4 * it) }
        return try {
            FloatPicture(
                FloatImage(columns, rows, floats),
                hasAlpha,
            ).also { check(floats.all { it.isFinite() }) { "not finite, but accepted" } }
        } catch (e: InputError) {
            checkMessage(e)
            null
        }
    }

    private fun check(
        expected: Picture,
        actual: Picture,
        difference: Difference,
    ) {
        val errors = List(expected.width * expected.height) { pixel -> errors(expected, actual, pixel) }
        val differing = errors.count { it.max() > 0 }
        check(difference.differing == differing) { "${difference.differing} pixels differ, not $differing" }
        for (c in errors[0].indices) check(difference.maximum[c] == errors.maxOf { it[c] }) { "maximum ${difference.maximum[c]}" }
        val worst = errors.indices.maxBy { errors[it].max() }.takeIf { differing > 0 }
        check(difference.worst == worst?.let { Pixel(it % expected.width, it / expected.width) }) { "worst is ${difference.worst}" }
        val squares = errors.sumOf { pixel -> pixel.sumOf { it * it } } / (errors.size * errors[0].size)
        check(
            (difference.rmse == 0.0 && squares == 0.0) || abs(difference.rmse * difference.rmse / squares - 1) < 1e-9,
        ) { "rmse ${difference.rmse}" }
    }

    private fun check(
        expected: Picture,
        actual: Picture,
        window: Window,
    ) {
        val (across, down) = minOf(window.size, expected.width) to minOf(window.size, expected.height)

        fun mean(
            x: Int,
            y: Int,
        ) =
            (0 until across * down).sumOf { errors(expected, actual, (y + it / across) * expected.width + x + it % across).max() } /
                (across * down)
        val corners = (0..expected.height - down).flatMap { y -> (0..expected.width - across).map { x -> x to y } }
        val worst = corners.maxOf { (x, y) -> mean(x, y) }
        check(abs(window.error - worst) <= 1e-9 * worst) { "the worst window has ${window.error}, not $worst" }
        check(abs(mean(window.corner.x, window.corner.y) - window.error) <= 1e-9 * worst) { "another window than that at ${window.corner}" }
    }

    private fun errors(
        expected: Picture,
        actual: Picture,
        pixel: Int,
    ): DoubleArray =
        DoubleArray(if (expected.hasAlpha) 4 else 3) { c ->
            val i = 4 * pixel + c
            if (expected is BytePicture) {
                abs((expected.image.rgba[i].toInt() and 0xFF) - ((actual as BytePicture).image.rgba[i].toInt() and 0xFF)) / 255.0
            } else {
                abs((expected as FloatPicture).image.rgba[i].toDouble() - (actual as FloatPicture).image.rgba[i])
            }
        }
}

private fun readOrRefuse(file: ByteArray) {
    try {
        val picture = PictureFile.decode(file)
        check(picture.width > 0 && picture.height > 0)
        check(Difference.between(picture, picture).differing == 0) { "a picture differs from itself" }
    } catch (e: InputError) {
        checkMessage(e)
    }
}

private fun checkMessage(error: InputError) {
    val message = error.message.orEmpty()
    check(message.endsWith(".") && message.all { it in ' '..'~' }) { "not a sentence of one line: $message" }
}
