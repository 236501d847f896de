package cga.framework

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeText

class HomeTest {
    @Test
    fun `relative paths are below the home, absolute ones are themselves`(
        @TempDir folder: Path,
    ) {
        val before = System.setProperty("cga.home", "$folder")
        try {
            assertEquals(folder.resolve("shaders/a.vert"), Home.resolve("shaders/a.vert"))
            assertEquals(folder.resolve("b"), Home.resolve("${folder.resolve("b")}"))
            folder.resolve("c").writeText("text")
            assertEquals("text", String(Home.read("c", "shader")))
        } finally {
            if (before == null) System.clearProperty("cga.home") else System.setProperty("cga.home", before)
        }
    }

    @Test
    fun `without a home they are below the working directory`() {
        assumeTrue(System.getProperty("cga.home") == null)
        assertTrue(Home.resolve("shaders/scene.vert").exists())
    }

    @Test
    fun `a file that is there but cannot be read is named`() {
        // Linux answers an input/output error for the first page of a process's memory, to root too.
        val unreadable = Path.of("/proc/self/mem")
        assumeTrue(unreadable.exists())
        val message = assertThrows<InputError> { Home.read(unreadable, "texture") }.message.orEmpty()
        assertTrue("texture file $unreadable cannot be read" in message && "permissions" in message, message)
    }
}
