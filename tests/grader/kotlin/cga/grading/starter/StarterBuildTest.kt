package cga.grading.starter

import cga.grading.prepared.Kind
import cga.grading.prepared.NamedLibrary
import cga.grading.submission.Submission
import cga.grading.submission.SubmissionReader
import cga.testing.Need
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.w3c.dom.Element
import java.io.File
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readText

/** Students build the starter with Gradle, or with Maven where no Gradle can be had. */
@Slow
class StarterBuildTest {
    @TempDir
    lateinit var folder: Path

    private val starter get() = folder.resolve("üb ung")
    private val script get() = starter.resolve("build.gradle.kts").readText()
    private val pom by lazy { elements(starter.resolve("pom.xml").toFile()) }

    @BeforeEach
    fun write() = StarterExport.write(starter)

    @Test
    fun `both builds name the same libraries, versions and natives`() {
        // Gradle's Kotlin plugin adds the library of its own version.
        val kotlin = "org.jetbrains.kotlin:kotlin-stdlib:${version("kotlin")}"
        val named = libraries(script) + kotlin
        val natives = libraries(script.lines().single { "in listOf(" in it })
        assertTrue(named.size == 8 && "org.joml:joml:${version("joml")}" in named) { "$named" }
        assertEquals(named + natives.map { "$it:natives-\${platform}\${arm}" } + COACH, pomLibraries())
        assertTrue("libs/cga-coach.jar" in script && pomText("systemPath") == setOf("\${project.basedir}/libs/cga-coach.jar"))
        assertTrue("\"natives-\$platform\"" in script && pomText("firstThread") == setOf("", "-XstartOnFirstThread"))
        assertEquals(setOf("linux", "windows", "macos"), pomText("platform"))
        assertEquals(setOf(version("jvmTarget")), pomText("maven.compiler.release"))
        val arguments = (pomText("jdkArgs") + pomText("arm") + pomText("firstThread")).flatMap { it.split(' ') }.filter { it.isNotEmpty() }
        assertEquals(emptyList<String>(), arguments.filter { "\"$it\"" !in script })
    }

    /** So a machine that built ours has what the starter needs. */
    @Test
    fun `the plugins of its pom that are among ours have our versions`() {
        fun plugins(pom: List<Element>) =
            pom.filter { it.tagName == "plugin" }.associate { it.child("artifactId") to interpolated(it.child("version").orEmpty()) }
        val ours = plugins(elements(projectRoot.resolve("pom.xml")))
        val common = plugins(pom).filterKeys { it in ours }
        val plugins = setOf("kotlin-maven-plugin", "maven-resources-plugin", "maven-compiler-plugin", "maven-dependency-plugin")
        assertEquals(plugins, common.keys)
        assertEquals(ours.filterKeys { it in common }, common)
    }

    @Test
    fun `it compiles with Maven, without a network`() {
        if (System.getenv("PATH").split(File.pathSeparator).none { File(it, "mvn").canExecute() }) {
            Need.MAVEN.skip("needs Maven: apt-get install maven")
        }
        val log = folder.resolve("log").toFile()
        // Kotlin's daemon would outlive the test.
        val process =
            ProcessBuilder("mvn", "-q", "-B", "-o", "-Dkotlin.compiler.daemon=false", "compile")
                .directory(starter.toFile())
                .redirectErrorStream(true)
                .redirectOutput(log)
                .start()
        assertEquals(0, process.waitFor()) { log.readText() }
        assertTrue(starter.resolve("target/classes/cga/exercise/MainKt.class").exists()) { log.readText() }
    }

    @Test
    fun `it is a starter with either build or both`() {
        val asked = assertRecognised().libraries.map { it.name }.toSet()
        val fetched = pomLibraries() - COACH
        assertEquals(fetched.map { it.split(':')[1] }.toSet(), asked, "what is fetched for a starter that does not compile")
        for (file in listOf("build.gradle.kts", "settings.gradle.kts", "gradle/libs.versions.toml")) starter.resolve(file).deleteExisting()
        val found = assertRecognised().libraries
        assertEquals(fetched.map { it.substringBefore(":natives") }.toSet(), found.map { it.text() }.toSet())
    }

    private fun assertRecognised(): Submission {
        val submission = SubmissionReader.read(starter, folder.resolve("unpacked"))
        assertEquals(Kind.STARTER, submission.kind)
        assertEquals(version("kotlin"), submission.kotlin)
        return submission
    }

    private fun NamedLibrary.text() = "$group:$name:$version"

    private fun pomLibraries(): Set<String> {
        val dependencies = pom.filter { it.tagName == "dependency" }
        val parts = listOf("groupId", "artifactId", "version", "classifier")
        return dependencies.map { dependency -> interpolated(parts.mapNotNull { dependency.child(it) }.joinToString(":")) }.toSet()
    }

    private fun interpolated(text: String) =
        text.replace(Regex("""\$\{(\w+)\.version}""")) { version(it.groupValues[1]) }

    private fun pomText(tag: String) = pom.filter { it.tagName == tag }.map { it.textContent }.toSet()

    private fun elements(file: File): List<Element> {
        val all = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file).getElementsByTagName("*")
        return (0 until all.length).map { all.item(it) as Element }
    }

    private fun Element.child(tag: String): String? = getElementsByTagName(tag).item(0)?.textContent

    private companion object {
        /** It lies beside the sources, in no repository. */
        const val COACH = "cga:cga-coach:1.0"

        val CATALOGUE = projectRoot.resolve("gradle/libs.versions.toml").readText()

        fun version(name: String) = Regex("""(?m)^$name = "(.+)"""").find(CATALOGUE)!!.groupValues[1]

        /** What [script] names, with groups and versions. */
        fun libraries(script: String): Set<String> =
            Regex("""libs\.(lwjgl\.\w+|joml)\b""").findAll(script).map { library(it.groupValues[1]) }.toSet()

        /** With its group and version: what the catalogue says of `libs.lwjgl.core`. */
        fun library(alias: String): String {
            val line = Regex("""(?m)^${alias.replace('.', '-')} = \{ module = "(.+)", version.ref = "(.+)" }""")
            val (module, version) = line.find(CATALOGUE)!!.destructured
            return "$module:${version(version)}"
        }
    }
}
