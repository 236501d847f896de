package cga.imaging.file

import cga.framework.InputError
import java.util.zip.DataFormatException
import java.util.zip.Inflater

/** What the zlib stream in [bytes] says, which lies in one or more [pieces] of it; every doubt about it is an [InputError]. */
internal class InflatedStream(
    private val bytes: ByteArray,
    pieces: List<Piece>,
) : AutoCloseable {
    /** [length] bytes from [start]. */
    class Piece(
        val start: Int,
        val length: Int,
    )

    private val inflater = Inflater()
    private val rest = pieces.iterator()

    /** Fills [target] up to [length]. */
    fun read(
        target: ByteArray,
        length: Int,
    ) {
        var filled = 0
        while (filled < length) {
            val more = inflate(target, filled, length - filled)
            if (more == 0) throw InputError("its data end too early: save it again.")
            filled += more
        }
    }

    /** Checks that nothing is left, and zlib's checksum. */
    fun finish() {
        if (inflate(ByteArray(1), 0, 1) > 0) throw InputError("it holds more data than its size needs: save it again.")
        if (!inflater.finished()) throw InputError("its data end too early: save it again.")
        if (inflater.remaining > 0 || rest.asSequence().any { it.length > 0 }) {
            throw InputError("it holds more data than its size needs: save it again.")
        }
    }

    /** How many bytes came, at most [length]; 0 at the end of the stream or of the data. */
    private fun inflate(
        target: ByteArray,
        start: Int,
        length: Int,
    ): Int {
        while (true) {
            val count =
                try {
                    inflater.inflate(target, start, length)
                } catch (e: DataFormatException) {
                    throw InputError("its data are damaged (${e.message ?: "no reason given"}): save it again.", e)
                }
            if (count > 0 || inflater.finished()) return count
            if (inflater.needsDictionary()) throw InputError("its data are damaged (a dictionary is asked for): save it again.")
            if (!rest.hasNext()) return 0
            val piece = rest.next()
            inflater.setInput(bytes, piece.start, piece.length)
        }
    }

    override fun close(): Unit = inflater.end()
}
