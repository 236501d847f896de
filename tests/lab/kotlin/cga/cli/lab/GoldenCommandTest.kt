package cga.cli.lab

import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.moveTo
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** `cga golden` and `cga golden accept` as processes, in a copy of the project with goldens of its own. */
@Slow
class GoldenCommandTest {
    @TempDir
    private lateinit var folder: Path
    private val home by lazy { folder.resolve("home") }
    private val goldens by lazy { home.resolve("tests/golden") }
    private val shader by lazy { home.resolve("shaders/scene.frag") }

    @BeforeEach
    fun `a copy of the project with one golden`() {
        original.toFile().copyRecursively(home.toFile())
    }

    @Test
    fun `what was accepted passes, alone and by a pattern`() {
        assertEquals(listOf("step-4.1.json", "step-4.1.png", "tolerance.json"), files())
        for (pattern in listOf("step-4.1", "step-4.1*", "*4.1")) {
            val process = golden("--only", pattern)
            assertEquals(0, process.exitCode, "$process")
            assertTrue("step-4.1" in process.out && "1 pass" in process.out && "step-4.2" !in process.out, "$process")
        }
    }

    @Test
    fun `a missing golden and one without a case fail`() {
        rename("step-4.1", "step-4.0")
        val process = golden("--only", "step-4.*", "--context", "osmesa")
        assertEquals(1, process.exitCode, "$process")
        assertTrue("step-4.1: there is no golden" in process.out && "./cga golden accept step-4.1" in process.out, "$process")
        assertTrue("step-4.0: there is no case" in process.out, "$process")
    }

    @Test
    fun `a defect of a shader fails and names the shader, a comment in it is a warning`() {
        val text = shader.readText()
        shader.writeText(text.replace("vec3 color = emissive * emissiveTint", "vec3 color = 0.99 * emissive * emissiveTint"))
        val page = folder.resolve("page.html")
        val defect = golden("--only", "step-4.1", "--report", "$page")
        assertEquals(1, defect.exitCode, "$defect")
        assertTrue("inputs changed since approval (shaders/scene.frag): look at it" in defect.out, "$defect")
        assertTrue("max " in defect.out && page.exists(), "$defect")
        shader.writeText("$text// A comment.\n")
        val comment = golden("--only", "step-4.1")
        assertEquals(0, comment.exitCode, "$comment")
        assertTrue("1 warn" in comment.out && "no pixel did" in comment.out, "$comment")
        assertEquals(0, golden("accept", "--reason", "a comment", "step-4.1").exitCode)
        assertTrue("1 pass" in golden("--only", "step-4.1").out)
        assertTrue("a comment" in goldens.resolve("step-4.1.json").readText())
    }

    @Test
    fun `accept shows what was before, and replaces or adds`() {
        shader.writeText(shader.readText().replace("vec3 color = emissive * emissiveTint", "vec3 color = 0.5 * emissive * emissiveTint"))
        val added = golden("accept", "step-4.1", "--also", "--reason", "half as bright on purpose")
        assertEquals(0, added.exitCode, "$added")
        assertTrue("fail" in added.out && "approved as well" in added.out && "/255" in added.out, "$added")
        assertEquals(listOf("step-4.1.json", "step-4.1.png", "step-4.1~2.json", "step-4.1~2.png", "tolerance.json"), files())
        assertEquals(0, golden("--only", "step-4.1").exitCode)
        val again = golden("accept", "step-4.1", "--reason", "once more")
        assertTrue("approved already" in again.out, "$again")
        goldens.resolve("step-4.1~2.json").deleteExisting()
        goldens.resolve("step-4.1~2.png").deleteExisting()
        val replaced = golden("accept", "step-4.1", "--reason", "half as bright on purpose")
        assertEquals(0, replaced.exitCode, "$replaced")
        assertEquals(listOf("step-4.1.json", "step-4.1.png", "tolerance.json"), files())
        assertTrue("half as bright" in goldens.resolve("step-4.1.json").readText())
    }

    @Test
    fun `accept refuses in CI, without a reason, without a case, and for a case that is none`() {
        val before = goldens.resolve("step-4.1.png").readBytes()
        shader.writeText(shader.readText().replace("vec3 color = emissive", "vec3 color = 0.5 * emissive"))
        for ((said, args) in listOf(
            "--reason" to listOf("step-4.1"),
            "say why" to listOf("step-4.1", "--reason", " "),
            "--all" to listOf("--reason", "r"),
            "one of the two" to listOf("--all", "step-4.1", "--reason", "r"),
            "step-9 is no case" to listOf("step-9", "--reason", "r"),
        )) {
            val process = golden("accept", *args.toTypedArray())
            assertEquals(2, process.exitCode, "$process")
            assertTrue(said in process.err, "$said: $process")
        }
        val process = golden("accept", "step-4.1", "--reason", "r", env = mapOf("CI" to "true"))
        assertEquals(2, process.exitCode, "$process")
        assertTrue("CI" in process.err, "$process")
        assertArrayEquals(before, goldens.resolve("step-4.1.png").readBytes())
    }

    @Test
    fun `without a tier for the renderer a difference is skipped, and in CI it fails`() {
        val tolerance = goldens.resolve("tolerance.json")
        tolerance.writeText(tolerance.readText().replace("llvmpipe.*", "another.*"))
        shader.writeText(shader.readText().replace("vec3 color = emissive", "vec3 color = 0.5 * emissive"))
        val skipped = golden("--only", "step-4.1")
        assertEquals(0, skipped.exitCode, "$skipped")
        assertTrue("1 skipped" in skipped.out && "skipped: needs " in skipped.out, "$skipped")
        val ci = golden("--only", "step-4.1", env = mapOf("CI" to "true"))
        assertEquals(1, ci.exitCode, "$ci")
    }

    @Test
    fun `bad usage ends in one message`() {
        for ((said, args) in listOf(
            "no case has such a name: did you mean step-4.1 or " to listOf("--only", "stpe-4.1"),
            "does not exist" to listOf("--report", "none/page.html"),
        )) {
            val process = golden(*args.toTypedArray())
            assertEquals(2, process.exitCode, "$process")
            assertTrue(said in process.err && "Exception" !in process.err, "$process")
            assertFalse("│" in process.out, "$process")
        }
    }

    private fun golden(
        vararg args: String,
        env: Map<String, String?> = OUTSIDE_CI,
    ): CgaProcess = CgaProcess.cga("golden", *args, directory = folder, home = home, env = env)

    private fun files() = goldens.listDirectoryEntries().map { it.name }.sorted()

    private fun rename(
        from: String,
        to: String,
    ) {
        for (kind in listOf("png", "json")) goldens.resolve("$from.$kind").moveTo(goldens.resolve("$to.$kind"))
    }

    private companion object {
        val OUTSIDE_CI = mapOf("CI" to null)

        @TempDir
        @JvmStatic
        lateinit var original: Path

        /** Made once: the copy of the project, whose golden is of this very machine. */
        @BeforeAll
        @JvmStatic
        fun `a project`() {
            Offscreen.openOrSkip().close()
            for (name in listOf("shaders", "assets", "tests/golden/tolerance.json")) {
                projectRoot.resolve(name).copyRecursively(original.resolve(name).toFile().also { it.parentFile.mkdirs() })
            }
            val accept = arrayOf("golden", "accept", "step-4.1", "--reason", "for this test")
            val process = CgaProcess.cga(*accept, directory = original, home = original, env = OUTSIDE_CI)
            assertEquals(0, process.exitCode, "$process")
        }
    }
}
