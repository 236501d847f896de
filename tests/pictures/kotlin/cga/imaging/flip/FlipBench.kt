package cga.imaging.flip

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import com.sun.management.OperatingSystemMXBean
import java.lang.management.ManagementFactory
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path

/**
 * The half of `tests/flip/bench.py` that runs here: for each line on standard input, LDR or HDR, it compares two pictures and prints the
 * milliseconds that passed and those that all processors together spent.
 *
 * Arguments: width, height, the files of the expected and of the actual picture (linear or sRGB, RGBA, 32-bit floats, little-endian).
 */
internal object FlipBench {
    private val system = ManagementFactory.getOperatingSystemMXBean() as OperatingSystemMXBean

    @JvmStatic
    fun main(args: Array<String>) {
        val (width, height) = args.take(2).map(String::toInt)
        val images = args.drop(2).map { FloatImage(width, height, floats(Path.of(it))) }
        val pictures = mapOf<String, List<Picture>>(
            "LDR" to images.map { BytePicture(bytes(it), hasAlpha = false) },
            "HDR" to images.map { FloatPicture(it, hasAlpha = false) },
        )
        for (kind in generateSequence(::readlnOrNull)) {
            val (expected, actual) = pictures.getValue(kind)
            val start = System.nanoTime()
            val cpuStart = system.processCpuTime
            val mean = Flip.compare(expected, actual).mean
            println("${(System.nanoTime() - start) / 1e6} ${(system.processCpuTime - cpuStart) / 1e6} $mean")
        }
    }

    private fun floats(file: Path): FloatArray {
        val buffer = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer()
        return FloatArray(buffer.remaining()).also(buffer::get)
    }

    private fun bytes(image: FloatImage) =
        ImageData(image.width, image.height, ByteArray(image.rgba.size) { Math.round(image.rgba[it].coerceIn(0f, 1f) * 255).toByte() })
}
