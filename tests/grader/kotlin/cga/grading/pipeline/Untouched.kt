package cga.grading.pipeline

import org.junit.jupiter.api.Assertions.assertEquals
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import kotlin.io.path.PathWalkOption
import kotlin.io.path.isRegularFile
import kotlin.io.path.readBytes
import kotlin.io.path.walk

/** What no submission may change, as it is now: names, kinds, times, rights and contents of all below [folders]. */
internal class Untouched(private vararg val folders: Path) {
    private val before = state()

    private fun state(): Map<String, List<Byte>> =
        folders.flatMap { it.walk(PathWalkOption.INCLUDE_DIRECTORIES) }.associate { path ->
            val attributes = Files.readAttributes(path, "unix:mode,ino,uid,nlink,lastModifiedTime", NOFOLLOW_LINKS)
            "$path ${attributes.toSortedMap()}" to if (path.isRegularFile()) path.readBytes().toList() else emptyList()
        }

    /** Fails where anything is not as it was. */
    fun check() {
        val now = state()
        assertEquals(before.keys.sorted().joinToString("\n"), now.keys.sorted().joinToString("\n"))
        assertEquals(before, now)
    }
}
