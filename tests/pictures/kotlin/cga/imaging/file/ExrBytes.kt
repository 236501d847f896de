package cga.imaging.file

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** OpenEXR files by hand, right and wrong ones. */
internal class ExrBytes(
    private val width: Int,
    private val height: Int,
) {
    /** Names and types (0 whole numbers, 1 half, 2 float) in the order of the file. */
    var channels = listOf("B" to 2, "G" to 2, "R" to 2)
    var compression = 0
    var version = 2
    var sampling = 1
    var top = 0
    var dataWindow = listOf(0, 0, width - 1, height - 1)
    var displayWindow: List<Int>? = null

    /** Attributes to leave out. */
    var without = setOf<String>()

    /** The file; [blocks] are the blocks' contents as they are to be stored. */
    fun of(vararg blocks: ByteArray): ByteArray {
        val header = header()
        val rows = if (compression == 3) 16 else 1
        var place = header.size + 8L * blocks.size
        val out = ByteArrayOutputStream()
        out.write(header)
        for (block in blocks) {
            out.write(little(8) { putLong(place) })
            place += 8 + block.size
        }
        blocks.forEachIndexed { i, block ->
            out.write(little(8) { putInt(top + i * rows).putInt(block.size) })
            out.write(block)
        }
        return out.toByteArray()
    }

    private fun header(): ByteArray {
        val window = listOf(dataWindow[0], dataWindow[1] + top, dataWindow[2], dataWindow[3] + top)
        val list = channels.fold(ByteArray(0)) { bytes, (name, type) ->
            bytes + text(name) + little(16) { putInt(type).putInt(0).putInt(sampling).putInt(sampling) }
        }
        val attributes =
            listOf(
                attribute("channels", "chlist", list + 0),
                attribute("compression", "compression", byteArrayOf(compression.toByte())),
                attribute("dataWindow", "box2i", box(window)),
                attribute("displayWindow", "box2i", box(displayWindow ?: window)),
                attribute("lineOrder", "lineOrder", byteArrayOf(0)),
            )
        return attributes.fold(ExrHeader.MAGIC + little(4) { putInt(version) }, ByteArray::plus) + 0
    }

    private fun attribute(
        name: String,
        type: String,
        content: ByteArray,
    ): ByteArray = if (name in without) ByteArray(0) else text(name) + text(type) + little(4) { putInt(content.size) } + content

    private fun box(sides: List<Int>) = little(16) { sides.forEach { putInt(it) } }

    private fun text(text: String) = text.toByteArray(Charsets.ISO_8859_1) + 0

    companion object {
        fun little(
            size: Int,
            fill: ByteBuffer.() -> Unit,
        ): ByteArray = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN).apply(fill).array()

        fun floats(vararg values: Float): ByteArray = little(4 * values.size) { values.forEach { putFloat(it) } }

        fun halves(vararg bits: Int): ByteArray = little(2 * bits.size) { bits.forEach { putShort(it.toShort()) } }

        /** What ZIP does to a block: even bytes before odd ones, differences from byte to byte, zlib; nothing where that would not help. */
        fun zipped(block: ByteArray): ByteArray {
            val halves = block.filterIndexed { i, _ -> i % 2 == 0 } + block.filterIndexed { i, _ -> i % 2 == 1 }
            val zip = deflated(ByteArray(block.size) { i -> if (i == 0) halves[0] else (halves[i] - halves[i - 1] + 128).toByte() })
            return if (zip.size < block.size) zip else block
        }
    }
}
