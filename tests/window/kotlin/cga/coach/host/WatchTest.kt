package cga.coach.host

import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import kotlin.io.path.writeText

class WatchTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `it notices a file that is written, and one that is replaced, once each`() {
        val shader = folder.resolve("scene.frag").apply { writeText("void main() {}") }
        watch().use { watch ->
            assertFalse(watch.hasChanged())
            shader.writeText("void main() { }")
            assertTrue(notices(watch))
            assertFalse(watch.hasChanged())
            val other = folder.resolve("other").apply { writeText("void main() {  }") }
            Files.move(other, shader, REPLACE_EXISTING)
            assertTrue(notices(watch))
        }
    }

    @Test
    fun `other files are none of its business`() {
        folder.resolve("scene.frag").writeText("1")
        watch().use { watch ->
            folder.resolve("scene.frag~").writeText("2")
            folder.resolve("notes.txt").writeText("3")
            // Longer than two of its looks; a mistake here can only be missed, never reported wrongly.
            Thread.sleep(600)
            assertFalse(watch.hasChanged())
        }
    }

    private fun watch() = Watch({ listOf(folder) }) { it.endsWith(".frag") }

    /** Whether it does within a time that no machine needs. */
    private fun notices(watch: Watch): Boolean = (0 until 600).any { Thread.sleep(50).let { watch.hasChanged() } }
}
