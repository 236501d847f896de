package cga.grading.course

import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.time.Instant
import java.time.temporal.ChronoUnit
import kotlin.io.path.readLines
import kotlin.io.path.writeText

/**
 * `journal.jsonl`: what happened when, a JSON object a line, only ever added to. It tells what was interrupted; what is done is told by the
 * outcomes themselves.
 */
internal class Journal(
    private val file: Path,
) {
    /** Adds a line: the [event], the submission's [folder], and [values]. */
    @Synchronized
    fun add(event: String, folder: String, vararg values: Pair<String, String>) {
        val time = Instant.now().truncatedTo(ChronoUnit.MILLIS)
        val line = listOf("time" to "$time", "event" to event, "submission" to folder) + values
        // A kill may have left half a line: it ends here, so that it spoils only itself.
        val end = if (endsInLine()) "" else "\n"
        file.writeText(
            end + JsonObject(
                line.associate { (key, value) ->
                    key to JsonPrimitive(value)
                },
            ) + "\n",
            Charsets.UTF_8,
            CREATE,
            APPEND,
        )
    }

    /** The folders of submissions that were begun and not ended. */
    fun interrupted(): Set<String> {
        if (!Files.exists(file)) return emptySet()
        val open = linkedSetOf<String>()
        for (line in file.readLines()) {
            val folder = LINE.find(line)?.groupValues ?: continue
            if (folder[1] == START) open += folder[2] else open -= folder[2]
        }
        return open
    }

    private fun endsInLine(): Boolean {
        if (!Files.exists(file)) return true
        Files.newByteChannel(file).use { channel ->
            if (channel.size() == 0L) return true
            val last = ByteBuffer.allocate(1)
            channel.position(channel.size() - 1).read(last)
            return last[0] == '\n'.code.toByte()
        }
    }

    companion object {
        const val NAME = "journal.jsonl"
        const val START = "start"
        const val DONE = "done"

        /** A result of an earlier run was taken over. */
        const val KEPT = "kept"

        // Folder names are plain, so they need no unescaping.
        private val LINE = Regex(""""event":"(\w+)","submission":"([^"\\]+)"""")
    }
}
