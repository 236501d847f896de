package cga.grading.capture

import java.io.BufferedInputStream
import java.io.BufferedOutputStream
import java.io.DataInputStream
import java.io.DataOutputStream
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream
import java.util.zip.Inflater
import java.util.zip.InflaterInputStream

/**
 * A [Capture] as one file: eight bytes that name the format and its version, then everything else deflated.
 *
 * What is read may have been written by anybody: every number is checked before it is used, and what [read] returns holds together (see
 * [CaptureCheck]).
 */
public object CaptureFile {
    /** Writes [capture] whole or not at all. Throws [IOException]. */
    public fun write(
        capture: Capture,
        file: Path,
    ) {
        val target = file.toAbsolutePath()
        val part = target.resolveSibling(".${target.fileName}.part")
        try {
            write(capture, BufferedOutputStream(Files.newOutputStream(part), BUFFER))
            Files.move(part, target, ATOMIC_MOVE, REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(part)
        }
    }

    private fun write(
        capture: Capture,
        out: BufferedOutputStream,
    ) {
        // Speed before size: the file is read once and thrown away.
        val deflater = Deflater(Deflater.BEST_SPEED)
        try {
            out.use {
                DataOutputStream(out).writeLong(MAGIC)
                val deflated = DeflaterOutputStream(out, deflater, BUFFER)
                val data = DataOutputStream(BufferedOutputStream(deflated, BUFFER))
                CaptureWriter(data).write(capture)
                data.flush()
                deflated.finish()
            }
        } finally {
            deflater.end()
        }
    }

    /**
     * The capture in [file]. Throws [BadCapture] for whatever is wrong with its content, another [IOException] where the file cannot be read.
     *
     * @param limit bytes that it may have when inflated, at most [CaptureLimits.BYTES].
     */
    public fun read(
        file: Path,
        limit: Long = CaptureLimits.BYTES,
    ): Capture =
        Files.newInputStream(file).use { raw ->
            val buffered = BufferedInputStream(raw, BUFFER)
            val head = DataInputStream(buffered)
            if (Files.size(file) < Long.SIZE_BYTES ||
                head.readLong() != MAGIC
            ) {
                throw BadCapture("this is not a capture file of this version")
            }
            val inflater = Inflater()
            val capture =
                try {
                    val input = LimitedInput(InflaterInputStream(buffered, inflater, BUFFER), minOf(limit, CaptureLimits.BYTES))
                    CaptureReader(input).read().also { input.expectEnd() }.also { expectEnd(inflater, buffered) }
                } finally {
                    inflater.end()
                }
            CaptureCheck(capture).check()
            capture
        }

    private fun expectEnd(
        inflater: Inflater,
        rest: InputStream,
    ) {
        if (inflater.remaining > 0 || rest.read() >= 0) throw BadCapture("something follows the end of the capture")
    }

    /** Of the format, and of what the recorder notes: another number where a submission's capture becomes another. */
    public const val VERSION: Int = 2
    private const val BUFFER = 1 shl 16

    // "CGACAP" and the version.
    private const val MAGIC = 0x4347414341500000L + VERSION
}
