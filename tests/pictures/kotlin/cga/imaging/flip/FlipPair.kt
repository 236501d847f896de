package cga.imaging.flip

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import kotlin.io.path.inputStream
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** Two pictures and what NVIDIA's implementation says of them; `tests/flip/oracle.py` made the files and describes them. */
internal class FlipPair private constructor(
    val name: String,
    header: List<String>,
    body: ByteBuffer,
) {
    private val width = header[1].toInt()
    private val height = header[2].toInt()
    private val isHdr = header[0] == "HDR"

    val pixelsPerDegree: Double = header[3].toDouble()

    /** NVIDIA's figure, a sum of floats. */
    val mean: Double = header[4].toDouble()

    /** The mean of NVIDIA's map, summed up in double. */
    val mapMean: Double = header[5].toDouble()

    /** Null for LDR. */
    val exposures: Exposures? = if (isHdr) Exposures(header[6].toFloat(), header[7].toFloat(), header[8].toInt()) else null

    val expected: Picture = picture(body)
    val actual: Picture = picture(body)

    /** Known to 1/131070. */
    val error: DoubleArray = DoubleArray(width * height) { (body.short.toInt() and 0xffff) / 65535.0 }

    private fun picture(body: ByteBuffer): Picture =
        if (isHdr) {
            FloatPicture(
                FloatImage(
                    width,
                    height,
                    FloatArray(4 * width * height) {
                        if (it % 4 ==
                            3
                        ) {
                            1f
                        } else {
                            body.float
                        }
                    },
                ),
                hasAlpha = false,
            )
        } else {
            BytePicture(ImageData(width, height, ByteArray(4 * width * height) { if (it % 4 == 3) -1 else body.get() }), hasAlpha = false)
        }

    companion object {
        private val FOLDER = Path.of("tests/flip")
        private const val SUFFIX = ".pair.gz"

        fun all(): List<FlipPair> = FOLDER.listDirectoryEntries("*$SUFFIX").sorted().map(::read)

        /** The colours of the 256 steps of error, as rrggbb. */
        fun magma(): List<String> = Files.readAllLines(FOLDER.resolve("magma.txt"))

        private fun read(file: Path): FlipPair {
            val bytes = GZIPInputStream(file.inputStream()).use { it.readAllBytes() }
            val lineEnd = bytes.indexOf('\n'.code.toByte())
            val header = String(bytes, 0, lineEnd).split(' ')
            val body = ByteBuffer.wrap(bytes, lineEnd + 1, bytes.size - lineEnd - 1).order(ByteOrder.LITTLE_ENDIAN)
            return FlipPair(file.name.removeSuffix(SUFFIX), header, body)
        }
    }
}
