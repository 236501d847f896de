package cga.inspect

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.concurrent.thread
import kotlin.io.path.extension
import kotlin.io.path.fileSize
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.listDirectoryEntries

/**
 * Notices that a shader in [folder] was saved. It looks four times a second, on a thread of its own: editors replace files in more ways than
 * any notification of the operating system reports.
 */
internal class ShaderWatch(private val folder: Path) : AutoCloseable {
    private val changed = AtomicBoolean()

    // Not left to the thread, which may start late: what is saved from now on counts.
    private var known = emptyList<String>()

    init {
        known = fingerprint()
    }

    private val looking = thread(isDaemon = true, name = "shader watch") { look() }

    /** Whether a shader was saved since the last call. */
    fun hasChanged(): Boolean = changed.getAndSet(false)

    private fun look() {
        try {
            var last = known
            while (true) {
                Thread.sleep(PAUSE_MILLIS)
                val now = fingerprint()
                // Told when it stays the same for a moment: until then the editor may still be writing.
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

    private fun fingerprint(): List<String> =
        try {
            folder
                .listDirectoryEntries()
                .filter { it.extension in TYPES && Files.isRegularFile(it) }
                .map { "${it.fileName} ${it.fileSize()} ${it.getLastModifiedTime()}" }
                .sorted()
        } catch (_: IOException) {
            // A file that is being replaced, for an instant not there.
            known
        }

    override fun close() {
        looking.interrupt()
        looking.join()
    }

    private companion object {
        const val PAUSE_MILLIS = 125L
        val TYPES = setOf("vert", "frag", "glsl")
    }
}
