package cga.build

import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

/** Gradle's build and Maven's say the same; and were they not to, this would tell. */
class BuildParityTest {
    private val catalogue = read("gradle/libs.versions.toml")
    private val settings = read("settings.gradle.kts")
    private val script = read("build.gradle.kts")
    private val pom = read("pom.xml")
    private val folders = (PARTS.map { "src/$it" } + "tests/program").associateBy { it.substringAfter('/') }
    private val scripts = folders.mapValues { read("${it.value}/build.gradle.kts") }
    private val poms = folders.mapValues { read("${it.value}/pom.xml") }

    @Test
    fun `Gradle and Maven build the same`() {
        assertEquals("", report())
    }

    @Test
    fun `both are read to the end`() {
        for (facts in listOf(gradleFacts(catalogue, settings, script, scripts), mavenFacts(pom, poms))) {
            assertEquals(folders.values.joinToString(), facts["parts"])
            assertEquals("kotlin", facts["main sources"])
            assertEquals("tests/\$name/kotlin", facts["test sources"])
            assertEquals("17", facts["JVM target"])
            assertTrue("scene: runtime org.lwjgl:lwjgl-assimp:natives-windows" in facts) { "$facts" }
            assertTrue("scene: compile org.joml:joml" in facts && "lab: test org.junit.jupiter:junit-jupiter" in facts) { "$facts" }
            assertTrue("window: compile cga:cli" in facts && "window: test cga:scene:tests" in facts) { "$facts" }
        }
    }

    @Test
    fun `what changes in the poms alone is reported`() {
        fun report(old: String, new: String) = report(pom = changed(pom, old, new))

        fun reportOfScene(old: String, new: String) = report(poms = poms + ("scene" to changed(poms.getValue("scene"), old, new)))
        val extra = "<dependency><groupId>a</groupId><artifactId>b</artifactId><version>7</version></dependency>"

        assertReport("scene: compile org.joml:joml: Gradle *, Maven 0.1", report("<joml.version>.*?<", "<joml.version>0.1<"))
        assertReport("scene: compile org.joml:joml: Gradle *, Maven nothing", reportOfScene("<dependency><groupId>org.joml<.*", ""))
        assertReport("scene: compile a:b: Gradle nothing, Maven 7", reportOfScene("</dependencies>", "$extra</dependencies>"))
        val missing = reportOfScene(".*>lwjgl<.*>natives-macos<.*", "")
        assertReport("scene: runtime org.lwjgl:lwjgl:natives-macos: Gradle *, Maven nothing", missing)
        val program = changed(poms.getValue("program"), " *<resource>.*/lab/.*\n", "")
        assertReport("tested together: Gradle *, lab, program, Maven *, grader, program", report(poms = poms + ("program" to program)))
        assertReport("main sources: Gradle kotlin, Maven src", report(">kotlin<", ">src<"))
        assertReport("test sources: Gradle *, Maven src/test", report("<testSourceDirectory>.*?<", "<testSourceDirectory>src/test<"))
        assertReport("JVM target: Gradle 17, Maven 21", report("<jvmTarget.version>17", "<jvmTarget.version>21"))
        assertReport("Kotlin: Gradle *, Maven 2.0.0", report("(?<=kotlin-maven-plugin</artifactId>\n {8}<version>).*?(?=<)", "2.0.0"))
        assertReport("warnings are errors: Gradle true, Maven false", report("-Werror", "-Wextra"))
        assertReport("test processes: Gradle 2, Maven 1", report(">2</forkCount>", ">1</forkCount>"))
        assertReport("test environment MESA_GL_VERSION_OVERRIDE: Gradle 3.3, Maven 4.5", report("OVERRIDE>3.3<", "OVERRIDE>4.5<"))
    }

    @Test
    fun `what changes in Gradle's files alone is reported`() {
        fun report(old: String, new: String) = report(script = changed(script, old, new))
        val oldJoml = changed(catalogue, "joml = \".*\"", "joml = \"0.1\"")

        assertReport("scene: compile org.joml:joml: Gradle 0.1, Maven *", report(catalogue = oldJoml))
        assertReport("main sources: Gradle src, Maven kotlin", report("listOf\\(\"kotlin\"\\)", "listOf(\"src\")"))
        assertReport("test sources: Gradle *, Maven *", report("tests/.name", "test"))
        assertReport("JVM target: Gradle 21, Maven 17", report("(fromTarget\\().*\\)", "$1\"21\")"))
        assertReport("explicit API: Gradle false, Maven true", report("explicitApi\\(\\)", "explicitApiWarning()"))
        assertReport("test heap: Gradle 1g, Maven 2g", report("maxHeapSize = .*", "maxHeapSize = \"1g\""))
        val allMissing = List(8) { "*: runtime *: Gradle nothing, Maven *" }.joinToString()
        assertReport(allMissing.replace("runtime *:", "runtime *:*:natives-macos-arm64:"), report(", \"macos-arm64\"", ""))
    }

    @Test
    fun `a form that it cannot read is not passed over`() {
        fun complaint(old: String, new: String) =
            assertThrows<IllegalStateException> {
                report(
                    scripts = scripts + ("scene" to changed(scripts.getValue("scene"), old, new)),
                )
            }.message

        val dependency = "api(\"a:b:1\")"
        assertReport("build.gradle.kts: cannot read the dependency: $dependency", complaint("api\\(libs.joml\\)", dependency))
        assertReport("libs.versions.toml: [joml] is not used by any part", complaint(".*libs.joml.*", ""))
        val folder = assertThrows<IllegalStateException> { report(script = changed(script, "explicitApi\\(\\)", "kotlin.srcDir(\"x\")")) }
        assertReport("build.gradle.kts: source folders are set in a form *", folder.message)
    }

    /** The differences, each naming the fact and what either build says of it. */
    private fun report(
        catalogue: String = this.catalogue,
        script: String = this.script,
        scripts: Map<String, String> = this.scripts,
        pom: String = this.pom,
        poms: Map<String, String> = this.poms,
    ): String {
        val gradle = gradleFacts(catalogue, settings, script, scripts)
        val maven = mavenFacts(pom, poms)
        val differences = (gradle.keys + maven.keys).filter { gradle[it] != maven[it] }
        return differences.joinToString { "$it: Gradle ${gradle[it] ?: "nothing"}, Maven ${maven[it] ?: "nothing"}" }
    }

    /** [report] is [expected], where `*` stands for anything without a colon: a version, a module. */
    private fun assertReport(expected: String, report: String?) {
        val pattern = expected.split('*').joinToString("[^:]*") { Regex.escape(it) }
        assertTrue(Regex(pattern).matches(report.orEmpty())) { "expected: $expected\nreported: $report" }
    }

    private fun changed(text: String, old: String, new: String): String =
        text.replaceFirst(Regex(old), new).also { assertNotEquals(text, it, "nothing is like $old") }

    private fun read(path: String) = projectRoot.resolve(path).readText()
}
