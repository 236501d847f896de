package cga.coach.host

import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.concurrent.thread
import kotlin.io.path.fileSize
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.isRegularFile

/**
 * Notices that one of the files below [folders] was saved whose name [isWatched]. It looks eight times a second, on a thread of its own:
 * editors replace files in more ways than any notification of the operating system reports.
 */
internal class Watch(
    private val folders: () -> List<Path>,
    private val isWatched: (String) -> Boolean,
) : AutoCloseable {
    private val changed = AtomicBoolean()

    // Not left to the thread, which may start late: what is saved from now on counts.
    private var known = emptyMap<String, String>()

    init {
        known = fingerprint()
    }

    private val looking = thread(isDaemon = true, name = "watch") { look() }

    /** Whether a file was saved since the last call. */
    fun hasChanged(): Boolean = changed.getAndSet(false)

    private fun look() {
        try {
            var last = known
            while (true) {
                Thread.sleep(PAUSE_MILLIS)
                val now = fingerprint()
                // Told when it stays the same for a moment: until then somebody may still be writing.
                if (now == last && now != known) {
                    known = now
                    changed.set(true)
                }
                last = now
            }
        } catch (_: InterruptedException) {
            return
        }
    }

    private fun fingerprint(): Map<String, String> =
        try {
            buildMap {
                for (folder in folders().filter(Files::exists)) {
                    Files.walk(folder).use { paths ->
                        paths.filter { isWatched("${it.fileName}") && it.isRegularFile() }.forEach {
                            put("$it", "${it.fileSize()} ${it.getLastModifiedTime()}")
                        }
                    }
                }
            }
        } catch (_: IOException) {
            // A file that is being replaced, for an instant not there.
            known
        } catch (_: UncheckedIOException) {
            known
        }

    override fun close() {
        looking.interrupt()
        looking.join()
    }

    private companion object {
        const val PAUSE_MILLIS = 125L
    }
}
