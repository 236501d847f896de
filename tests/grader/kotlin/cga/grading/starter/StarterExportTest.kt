package cga.grading.starter

import cga.framework.InputError
import cga.testing.CgaProcess
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.isExecutable
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText

@Slow
class StarterExportTest {
    @Test
    fun `the starter and what was cut out of it are the solution, byte for byte`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target)
        for ((path, template) in StarterFiles.templates()) {
            val solution = projectRoot.resolve(path.replace("src/main/", "src/scene/")).readText()
            assertEquals(solution, Template.solution(target.resolve(path).readText(), template.regions), path)
        }
    }

    @Test
    fun `nothing of the solution is left`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target)
        val text = StarterFiles.templates().keys.joinToString("\n") { target.resolve(it).readText() }
        val secrets =
            listOf("reflect(", "normalize(sum)", "coneIntensity", "RADIANS_PER_PIXEL *", "parent = motorcycle }", "end of solution")
        for (secret in secrets) {
            assertFalse(secret in text, secret)
        }
    }

    @Test
    fun `every task of the sheet has a TODO`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target)
        val todos = StarterFiles.templates().keys.flatMap { target.resolve(it).readText().lines() }.filter { "// TODO " in it }
        val tasks = todos.map { it.substringAfter("// TODO ").substringBefore(':') }.toSet()
        assertEquals(setOf("4.2.1", "4.2.2", "4.2.3", "4.3.1", "4.3.2", "4.3.3", "4.3.4", "4.4", "4.5", "4.6", "4.7"), tasks)
    }

    @Test
    fun `it holds what a student needs and nothing of ours besides`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target)
        val files = target.toFile().walk().filter(File::isFile).map { it.relativeTo(target.toFile()).invariantSeparatorsPath }.toSet()
        val needed = listOf("README.md", "LICENSE", "build.gradle.kts", "gradlew.bat", "gradle/wrapper/gradle-wrapper.jar") +
            listOf("src/main/kotlin/cga/exercise/Main.kt", "assets/motorcycle/motorcycle.mtl", "shaders/scene.frag", ".gitignore")
        assertEquals(emptyList<String>(), needed - files)
        assertTrue(target.resolve("gradlew").isExecutable())
        assertEquals(listOf("cga-starter 1"), target.resolve(".cga-starter").readText().lines().filter(String::isNotEmpty))
        val ours = files.filter {
            it.startsWith("src/") && !it.startsWith("src/main/kotlin/cga/framework/") &&
                !it.startsWith("src/main/kotlin/cga/exercise/")
        }
        assertEquals(emptyList<String>(), ours)
        for (path in listOf("assets/motorcycle/motorcycle.obj", "gradle/wrapper/gradle-wrapper.jar")) {
            assertArrayEquals(projectRoot.resolve(path).readBytes(), target.resolve(path).readBytes(), path)
        }
        // The build takes its versions from our list, so that no second one has to be kept in step.
        val named = Regex("""libs\.((?:lwjgl\.\w+|joml))\b""")
            .findAll(target.resolve("build.gradle.kts").readText())
            .map {
                it.groupValues[1]
            }.toSet()
        val known = target.resolve("gradle/libs.versions.toml").readText()
        assertEquals(emptyList<String>(), named.filter { "\n${it.replace('.', '-')} = " !in known })
    }

    @Test
    fun `an empty folder is filled`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("here").createDirectory()
        StarterExport.write(target)
        assertTrue(target.resolve("README.md").exists())
        assertEquals(listOf("here"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun `a folder that holds something is left alone`(
        @TempDir folder: Path,
    ) {
        folder.resolve("mine.txt").writeText("mine")
        assertRefused(folder, "not empty")
        assertRefused(folder.resolve("mine.txt"), "is a file")
        assertRefused(folder.resolve("no/such"), "does not exist")
        assertRefused(Path.of("."), "not empty")
        assertEquals("mine", folder.resolve("mine.txt").readText())
        assertEquals(listOf("mine.txt"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun `on the command line it ends with 2 where it refuses, and 0 where it writes`(
        @TempDir folder: Path,
    ) {
        folder.resolve("mine.txt").writeText("mine")
        val refused = CgaProcess.cga("starter", ".", directory = folder)
        assertEquals(2, refused.exitCode, "$refused")
        assertTrue("not empty" in refused.err && refused.err.lines().size <= 2, "$refused")
        val written = CgaProcess.cga("starter", "new", directory = folder)
        assertEquals(0, written.exitCode, "$written")
        assertTrue(folder.resolve("new/.cga-starter").exists())
        val elsewhere = CgaProcess.cga("starter", "other", directory = folder, home = folder)
        assertEquals(2, elsewhere.exitCode, "$elsewhere")
        assertEquals(setOf("mine.txt", "new"), folder.listDirectoryEntries().map { it.name }.toSet())
    }

    private fun assertRefused(
        target: Path,
        reason: String,
    ) {
        val message = assertThrows<InputError> { StarterExport.write(target) }.message.orEmpty()
        assertTrue(reason in message) { message }
    }
}
