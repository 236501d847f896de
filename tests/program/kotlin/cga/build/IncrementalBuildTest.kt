package cga.build

import cga.testing.Need
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.moveTo
import kotlin.io.path.name
import kotlin.io.path.walk
import kotlin.io.path.writeText

/** For the launcher Maven compiles what changed only; what is gone must not live on in the class folders. */
@Slow
class IncrementalBuildTest {
    @Test
    fun `the classes of deleted and renamed files vanish, tests included`(
        @TempDir folder: Path,
    ) {
        if (System.getenv("PATH").split(File.pathSeparator).none {
                File(it, "mvn").canExecute()
            }
        ) {
            Need.MAVEN.skip("needs Maven: apt-get install maven")
        }
        val sources = folder.resolve("src/scene/kotlin").createDirectories()
        val tests = folder.resolve("tests/scene/kotlin").createDirectories()
        copyBuild(folder)
        sources.resolve("Kept.kt").writeText("package a\n\npublic class Kept\n")
        sources.resolve("Deleted.kt").writeText("package a\n\npublic class Deleted\n")
        sources.resolve("Renamed.kt").writeText("package a\n\npublic class Renamed\n")
        tests.resolve("DeletedTest.kt").writeText("package a\n\nclass DeletedTest {\n    val kept = Kept()\n}\n")
        tests.resolve("KeptTest.kt").writeText("package a\n\nclass KeptTest {\n    val kept = Kept()\n}\n")
        compile(folder)
        assertEquals(listOf("Deleted", "DeletedTest", "Kept", "KeptTest", "Renamed"), classes(folder))

        sources.resolve("Deleted.kt").deleteExisting()
        tests.resolve("DeletedTest.kt").deleteExisting()
        sources.resolve("Renamed.kt").moveTo(sources.resolve("Other.kt")).writeText("package a\n\npublic class Other\n")
        compile(folder)
        assertEquals(listOf("Kept", "KeptTest", "Other"), classes(folder))
    }

    /** The project's own build, with one part. */
    private fun copyBuild(folder: Path) {
        val modules = Regex("(?s)<modules>.*</modules>")
        val pom = projectRoot.resolve("pom.xml").readText().replace(modules, "<modules><module>src/scene</module></modules>")
        folder.resolve("pom.xml").writeText(pom)
        val part = projectRoot.resolve("src/scene/pom.xml").readText()
        folder.resolve("src/scene/pom.xml").writeText(part)
    }

    private fun compile(folder: Path) {
        val log = folder.resolve("log").toFile()
        val process =
            ProcessBuilder("mvn", "-B", "-o", "-Dkotlin.compiler.incremental=true", "test-compile")
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(log)
                .start()
        assertEquals(0, process.waitFor()) { log.readText() }
    }

    private fun classes(folder: Path): List<String> {
        val outputs = listOf("classes", "test-classes").map { folder.resolve("target/scene/$it") }.filter { it.exists() }
        return outputs.flatMap { it.walk() }.filter { it.extension == "class" }.map { it.name.removeSuffix(".class") }.sorted()
    }
}
