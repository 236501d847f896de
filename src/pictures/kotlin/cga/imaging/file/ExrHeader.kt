package cga.imaging.file

import cga.framework.InputError
import java.nio.BufferUnderflowException
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * The header of an OpenEXR file ("OpenEXR File Layout"), for the kind of file that is read: one part of scan lines, without loss.
 * Throws [InputError] for any other, naming what it is.
 */
internal class ExrHeader(
    file: ByteArray,
) {
    val width: Int
    val height: Int

    /** The number of the uppermost row. */
    val top: Int
    val compression: ExrCompression

    /** In the order in which they are stored. */
    val channels: List<ExrChannel>

    /** Where the header ends. */
    val end: Int

    init {
        val bytes = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN)
        val attributes =
            try {
                checkVersion(bytes.getInt(4))
                attributes(bytes.position(8))
            } catch (e: BufferUnderflowException) {
                throw InputError("it is cut off in its header: save it again.", e)
            } catch (e: IndexOutOfBoundsException) {
                throw InputError("it is cut off in its header: save it again.", e)
            }
        end = bytes.position()
        compression = ExrCompression.of(attributes.get("compression", "compression", 1).get())
        channels = ExrChannel.list(attributes.get("channels", "chlist", null))
        val window = box(attributes, "dataWindow")
        val shown = box(attributes, "displayWindow")
        val (left, upper, right, lower) = window
        checkSize(right.toLong() - left + 1, lower.toLong() - upper + 1)
        if (window !=
            shown
        ) {
            throw InputError("its pixels fill $window, and the picture shown is $shown: save it without a crop or a border.")
        }
        width = right - left + 1
        height = lower - upper + 1
        top = upper
    }

    private fun checkVersion(version: Int) {
        val flags = version ushr 8
        val kind =
            when {
                version and 0xFF != 2 -> "of version ${version and 0xFF}"
                flags and 0x08 != 0 -> "a deep picture"
                flags and 0x10 != 0 -> "of several parts"
                flags and 0x02 != 0 -> "stored in tiles"
                // 4 only allows longer names.
                flags and 0x04.inv() != 0 -> "of an unknown kind (flags $flags)"
                else -> return
            }
        throw InputError("it is $kind, and only single pictures of scan lines are read: save it as such.")
    }

    private class Attribute(
        val type: String,
        val content: ByteBuffer,
    )

    private fun attributes(bytes: ByteBuffer): Map<String, Attribute> {
        val found = HashMap<String, Attribute>()
        while (true) {
            val name = bytes.text()
            if (name.isEmpty()) return found
            val type = bytes.text()
            val size = bytes.getInt()
            if (size < 0 || size > bytes.remaining()) throw InputError("it is cut off in its header: save it again.")
            val content = bytes.slice(bytes.position(), size).order(ByteOrder.LITTLE_ENDIAN)
            bytes.position(bytes.position() + size)
            if (found.put(name, Attribute(type, content)) != null) throw InputError("its header has an attribute twice: save it again.")
        }
    }

    private fun Map<String, Attribute>.get(
        name: String,
        type: String,
        size: Int?,
    ): ByteBuffer {
        val attribute = this[name] ?: throw InputError("its header has no $name: save it again.")
        if (attribute.type != type || (size != null && attribute.content.remaining() != size)) {
            throw InputError("its header has a broken $name: save it again.")
        }
        return attribute.content
    }

    /** Left, top, right, bottom; the last two are inside. */
    private fun box(
        attributes: Map<String, Attribute>,
        name: String,
    ): List<Int> {
        val content = attributes.get(name, "box2i", 16)
        return List(4) { content.getInt() }
    }

    companion object {
        val MAGIC = byteArrayOf(0x76, 0x2F, 0x31, 0x01)
    }
}

/** A text that ends with a zero byte. Throws [BufferUnderflowException] where none is left. */
internal fun ByteBuffer.text(): String {
    val start = position()
    var length = 0
    while (get().toInt() != 0) length++
    return String(array(), arrayOffset() + start, length, Charsets.ISO_8859_1)
}

/** The ways to compress of which no value is changed and that zlib can undo. */
internal enum class ExrCompression(
    val code: Int,
    val rowsPerBlock: Int,
) {
    NONE(0, 1),
    ZIPS(2, 1),
    ZIP(3, 16),
    ;

    companion object {
        private val NAMES = listOf("none", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB", "HTJ2K256", "HTJ2K32")

        fun of(code: Byte): ExrCompression =
            entries.find { it.code == code.toInt() }
                ?: throw InputError(
                    "its compression is ${NAMES.getOrNull(code.toInt()) ?: "unknown ($code)"}: save it with ZIP, ZIPS or none.",
                )
    }
}
