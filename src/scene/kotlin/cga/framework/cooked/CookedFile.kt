package cga.framework.cooked

import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder.LITTLE_ENDIAN
import java.nio.channels.FileChannel
import java.nio.channels.FileChannel.MapMode.READ_ONLY
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE
import java.util.zip.CRC32

/**
 * The container of everything cooked: what was made of source files, and of which.
 *
 *     8 bytes  "CGACOOK" and the version of the format, 1
 *     int      bytes of the sources below
 *     int      bytes of the payload after them
 *     int      CRC-32 of both
 *     sources  their number; for each the length of its path, its bytes, its CRC-32, and the path in UTF-8, padded to 4
 *     payload  as its kind says
 *
 * Little-endian throughout; ints and floats lie at multiples of 4.
 */
public class CookedFile(
    public val sources: List<Fingerprint>,
    public val payload: ByteBuffer,
) {
    public fun write(file: Path) {
        val names = sources.map { it.path.toByteArray() }
        val size = Int.SIZE_BYTES + names.sumOf { SOURCE_BYTES + padded(it.size) }
        val bytes = ByteBuffer.allocate(HEADER_BYTES + size).order(LITTLE_ENDIAN)
        bytes.put(MAGIC).putInt(size).putInt(payload.remaining()).putInt(0)
        bytes.putInt(sources.size)
        for ((source, name) in sources zip names) {
            bytes.putInt(name.size).putInt(source.bytes).putInt(source.crc).put(name)
            while (bytes.position() % 4 != 0) bytes.put(0)
        }
        bytes.putInt(CRC_AT, checksum(bytes.array(), payload))
        FileChannel.open(file, CREATE, WRITE, TRUNCATE_EXISTING).use { channel ->
            for (part in listOf(bytes.flip(), payload.duplicate())) while (part.hasRemaining()) channel.write(part)
        }
    }

    /** What a source held when it was read: two files of the same size and checksum are taken for equal. */
    public data class Fingerprint(
        val path: String,
        val bytes: Int,
        val crc: Int,
    ) {
        public companion object {
            /** Of [file] as it is now. Throws [IOException]. */
            public fun of(file: Path): Fingerprint {
                val content = Files.readAllBytes(file)
                return Fingerprint(file.toString(), content.size, CRC32().apply { update(content) }.value.toInt())
            }
        }
    }

    public companion object {
        private val MAGIC = "CGACOOK1".toByteArray()
        private const val CRC_AT = 16
        private const val HEADER_BYTES = 20
        private const val SOURCE_BYTES = 12

        /** The container in [file], or null where there is none or it is damaged. Its payload is the file, mapped. */
        public fun read(file: Path): CookedFile? =
            try {
                FileChannel.open(file, READ).use { parse(it.map(READ_ONLY, 0, it.size()).order(LITTLE_ENDIAN)) }
            } catch (_: IOException) {
                null
            }

        private fun parse(bytes: ByteBuffer): CookedFile? {
            if (bytes.remaining() < HEADER_BYTES || bytes.slice(0, MAGIC.size) != ByteBuffer.wrap(MAGIC)) return null
            bytes.position(MAGIC.size)
            val sources = bytes.getInt()
            val payload = bytes.getInt()
            val crc = bytes.getInt()
            if (sources < 0 || payload < 0 || sources.toLong() + payload != bytes.remaining().toLong()) return null
            if (CRC32().apply { update(bytes.duplicate()) }.value.toInt() != crc) return null
            // The checksum fits, so what follows is what was written.
            val found = fingerprints(bytes.slice(bytes.position(), sources).order(LITTLE_ENDIAN))
            return CookedFile(found, bytes.slice(bytes.position() + sources, payload).order(LITTLE_ENDIAN))
        }

        private fun fingerprints(bytes: ByteBuffer): List<Fingerprint> =
            List(bytes.getInt()) {
                val name = ByteArray(bytes.getInt())
                val size = bytes.getInt()
                val crc = bytes.getInt()
                bytes.get(name).position(padded(bytes.position()))
                Fingerprint(String(name), size, crc)
            }

        private fun checksum(
            header: ByteArray,
            payload: ByteBuffer,
        ): Int =
            CRC32()
                .apply {
                    update(header, HEADER_BYTES, header.size - HEADER_BYTES)
                    update(payload.duplicate())
                }.value
                .toInt()

        public fun padded(bytes: Int): Int = (bytes + 3) and 3.inv()
    }
}
