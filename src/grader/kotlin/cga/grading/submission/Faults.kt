package cga.grading.submission

import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.Path

/** The job's user may not read what was handed in: it has to be given a copy. */
internal class Unreadable(e: AccessDeniedException) : Exception(e.message, e) {
    companion object {
        /** Throws [Unreadable] where that is what [e] means. */
        fun require(e: IOException) {
            if (e is AccessDeniedException) throw Unreadable(e)
        }
    }
}

/** Something could not be written, and not for what was to be written. */
internal class NoRoom(e: IOException) : Exception(e.message, e)

/** Whether there is room on the disk. */
internal object Room {
    private const val LEAST = 1L shl 20

    /** Throws [NoRoom] where [folder] cannot take a file, so that [e] is nobody's fault who handed something in. */
    fun require(folder: Path, e: IOException) {
        if (folder.toFile().usableSpace < LEAST) throw NoRoom(e)
    }
}
