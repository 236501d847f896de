package cga.grading.pipeline

import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.writeBytes

/** Whether what a step had to write could have been written. */
internal object DiskSpace {
    private const val TRIAL_BYTES = 1 shl 16

    /** What is wrong with the disk of [folder], which has to take [bytes], with the cure; null where nothing is. */
    fun lack(folder: Path, bytes: Long): String? {
        val trial = folder.resolve("trial")
        val room = folder.toFile().usableSpace
        return try {
            trial.writeBytes(ByteArray(TRIAL_BYTES))
            "The disk of $folder has only ${room shr 20} MiB left, and a submission may write ${bytes shr 20}: make room.".takeIf {
                room <
                    bytes
            }
        } catch (e: IOException) {
            "Nothing can be written to $folder ($e): is the disk full?"
        } finally {
            trial.deleteIfExists()
        }
    }
}
