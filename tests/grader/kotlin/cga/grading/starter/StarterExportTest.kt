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
import java.util.zip.ZipFile
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.isExecutable
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeText

@Slow
class StarterExportTest {
    @Test
    fun `the starter and what was cut out of it are the solution, byte for byte, in either language`(
        @TempDir folder: Path,
    ) {
        for (language in StarterLanguage.entries) {
            val target = folder.resolve(language.code)
            StarterExport.write(target, language)
            for ((path, template) in StarterFiles(language).templates()) {
                val left = target.resolve(path).takeIf(Path::exists)?.readText() ?: template.starter
                val solution = projectRoot.resolve("src/starter/$path").readText()
                assertEquals(solution, Template.solution(left, template.regions), path)
                assertEquals(left.isNotBlank(), target.resolve(path).exists(), path)
            }
        }
    }

    @Test
    fun `nothing of the solution is left`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target)
        val text = sources(target).joinToString("\n") { it.readText() }
        val secrets =
            listOf(
                "reflected(", "normalize(normalView)", "cosInner", "class PointLight(", "class SpotLight(", "0.002 *",
                "parent = motorcycle\n\n        spot",
            )
        for (secret in secrets + "end of solution" + "Lösung") assertFalse(secret in text, secret)
        val light = target.resolve("src/main/kotlin/cga/exercise/components/light")
        assertEquals(listOf("IPointLight.kt", "ISpotLight.kt"), light.listDirectoryEntries().map { it.name }.sorted())
    }

    @Test
    fun `every task of the sheet has a TODO, and there are about as many as tasks`(
        @TempDir folder: Path,
    ) {
        val tasks = StarterLanguage.entries.map { language ->
            val target = folder.resolve(language.code)
            StarterExport.write(target, language)
            val todos = sources(target).flatMap { it.readLines() }.filter { "// TODO " in it }
            todos.map { it.substringAfter("// TODO ").substringBefore(':') }
        }
        assertEquals(tasks.first(), tasks.last())
        assertEquals(
            setOf("4.2.1", "4.2.2", "4.2.3", "4.3.1", "4.3.2", "4.3.3", "4.3.4", "4.4", "4.5", "4.6", "4.7"),
            tasks.first().toSet(),
        )
        // What both shaders, or a shader and the scene, have a part in is there twice.
        assertTrue(tasks.first().size <= 15) { "${tasks.first()}" }
    }

    @Test
    fun `the window is a library without anything of the exercise`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target)
        val entries = target.resolve("libs").listDirectoryEntries("*.jar").associate { jar ->
            jar.name to ZipFile(jar.toFile()).use { zip ->
                zip.entries().toList().associate { it.name to zip.getInputStream(it).readAllBytes().toString(Charsets.ISO_8859_1) }
            }
        }
        val tools = entries.getValue("cga-coach-tools.jar")
        assertTrue("cga/coach/host/CoachHost.class" in tools && "cga/framework/GameWindow.class" in tools, "${tools.keys}")
        assertTrue("cga/coach/Stage.class" in entries.getValue("cga-coach.jar"), "${entries.getValue("cga-coach.jar").keys}")
        for ((name, content) in entries.values.flatMap { it.entries }) {
            assertTrue(name.startsWith("cga/coach/") || name.startsWith("cga/framework/"), name)
            assertTrue(name.substringAfterLast('.') in setOf("class", "ttf", "txt", "vert", "frag"), name)
            // What the solution's shaders are told by from others.
            for (secret in listOf("coneIntensity", "pointLight", "toCamera")) assertFalse(secret in content, "$name: $secret")
        }
    }

    private fun sources(target: Path): List<Path> =
        listOf("src", "assets/shaders").flatMap { folder -> target.resolve(folder).walk().filter { it.extension in setOf("kt", "glsl") } }

    @Test
    fun `it holds what a student needs and nothing of ours besides`(
        @TempDir folder: Path,
    ) {
        val target = folder.resolve("starter")
        StarterExport.write(target, StarterLanguage.GERMAN)
        val files = target.toFile().walk().filter(File::isFile).map { it.relativeTo(target.toFile()).invariantSeparatorsPath }.toSet()
        val needed = listOf("README.md", "LICENSE", "build.gradle.kts", "gradlew.bat", "gradle/wrapper/gradle-wrapper.jar") +
            listOf(
                "src/main/kotlin/cga/exercise/Main.kt",
                "assets/motorcycle/motorcycle.mtl",
                "assets/shaders/tron_frag.glsl",
                ".gitignore",
            )
        assertEquals(emptyList<String>(), needed - files)
        assertTrue(target.resolve("gradlew").isExecutable() && target.resolve("cga").isExecutable())
        val mark = target.resolve(".cga-starter").readLines().filter(String::isNotEmpty)
        assertEquals(listOf("cga-starter 2", "language de"), mark)
        assertTrue("Blatt 4" in target.resolve("README.md").readText())
        // The pages that students read do not lead to the solution.
        assertFalse("http" in target.resolve("README.md").readText())
        val top = files.map { it.substringBefore('/') }.toSet()
        val expected =
            setOf("README.md", "LICENSE", "build.gradle.kts", "settings.gradle.kts", "pom.xml", "gradle", "gradlew", "gradlew.bat") +
                setOf("src", "assets", "libs", "cga", ".gitignore", ".cga-starter")
        assertEquals(expected, top)
        for (path in listOf("assets/motorcycle/motorcycle.obj", "gradle/wrapper/gradle-wrapper.jar")) {
            assertArrayEquals(projectRoot.resolve(path).readBytes(), target.resolve(path).readBytes(), path)
        }
        // The build takes its versions from our list, so that no second one has to be kept in step.
        val script = target.resolve("build.gradle.kts").readText()
        val named = Regex("""libs\.((?:lwjgl\.\w+|joml))\b""").findAll(script).map { it.groupValues[1] }.toSet()
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
        val written = CgaProcess.cga("starter", "new", "--lang", "de", directory = folder)
        assertEquals(0, written.exitCode, "$written")
        assertTrue("language de" in folder.resolve("new/.cga-starter").readText())
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
