package cga.grading.submission

import cga.framework.InputError
import cga.grading.prepared.Edition
import cga.grading.prepared.Kind
import cga.grading.prepared.NamedLibrary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.writeText

class SubmissionReaderTest {
    @TempDir
    lateinit var folder: Path

    private fun read(files: Map<String, String> = MadeUp.FILES, edition: Edition? = null) =
        SubmissionReader.read(MadeUp.write(folder, files), folder.resolve("unused"), edition)

    private fun below(prefix: String, files: Map<String, String> = MadeUp.FILES) = files.mapKeys { "$prefix/${it.key}" }

    @Test
    fun `a course project is recognised with all that matters`() {
        val submission = read()
        assertEquals(Kind.COURSE, submission.kind)
        assertEquals("cga.exercise.MainKt", submission.mainClass)
        assertEquals(MadeUp.FILES.keys.filter { it.endsWith(".kt") }.sorted(), submission.sources.map { it.name })
        assertEquals(folder.toRealPath(), submission.workingDirectory)
        assertEquals("1.3.72", submission.kotlin)
        assertEquals("2021", submission.edition.edition.id)
        assertTrue(submission.edition.evidence.single().startsWith("rotateLocal in src/")) { "${submission.edition.evidence}" }
        assertEquals(emptyList<String>(), submission.notes)
    }

    @Test
    fun `a starter carries its mark`() = assertEquals(Kind.STARTER, read(MadeUp.FILES + (".cga-starter" to "1\n")).kind)

    @Test
    fun `a project is found wherever it lies, and what was built or copied is left out`() {
        val clutter = mapOf(
            "a/b/project/build/generated/cga/exercise/game/Scene.kt" to MadeUp.SCENE,
            "a/b/project/out/Scene.kt" to MadeUp.SCENE,
            "a/b/project/src/test/kotlin/cga/exercise/game/SceneTest.kt" to "package cga.exercise.game\n",
            "a/notes.kt" to "fun main() { }\n",
        )
        val submission = read(below("a/b/project") + below("a/b/project backup") + below("assets", mapOf("other/x.png" to "")) + clutter)
        assertEquals(below("a/b/project").keys.filter { it.endsWith(".kt") }.sorted(), submission.sources.map { it.name })
        assertEquals(folder.toRealPath().resolve("a/b/project"), submission.workingDirectory)
        assertTrue(submission.notes.single().startsWith("a/b/project backup holds another copy")) { "${submission.notes}" }
    }

    @Test
    fun `a project in two modules is one`() {
        val (framework, exercise) = MadeUp.FILES.entries.partition { "framework" in it.key }
        val files = framework.associate { "lib/${it.key}" to it.value } + exercise.associate { "app/${it.key}" to it.value }
        val submission = read(files)
        assertEquals(5, submission.sources.size)
        assertEquals(folder.toRealPath().resolve("app"), submission.workingDirectory)
    }

    @Test
    fun `sources without folders for packages, and assets above them, are found`() {
        val submission = read(mapOf("code/src/Main.kt" to MadeUp.MAIN, "code/src/Scene.kt" to MadeUp.SCENE, "assets/shaders/v.glsl" to ""))
        assertEquals(2, submission.sources.size)
        assertEquals(folder.toRealPath(), submission.workingDirectory)
    }

    @Test
    fun `the main function is found in all its shapes`() {
        val shapes = mapOf(
            "fun main() { Game().run() }" to "cga.exercise.MainKt",
            "@file:JvmName(\"Start\")\npackage cga.exercise\nfun main() { Game().run() }" to "cga.exercise.Start",
            "object App {\n    @JvmStatic\n    fun main(args: Array<String>) { Game().run() }\n}" to "cga.exercise.App",
        )
        for ((text, expected) in shapes) {
            val whole = if ("package" in text) text else "package cga.exercise\n$text"
            assertEquals(expected, SourceFile(Path.of("/x/Main.kt"), "Main.kt", whole).mainClass)
        }
        assertEquals(null, SourceFile(Path.of("/x/Main.kt"), "Main.kt", "package cga.exercise\n// fun main() is elsewhere").mainClass)
        val java = "package cga.exercise; public class Start { public static void main(String[] a) { new Game(); } }"
        assertEquals("cga.exercise.Start", SourceFile(Path.of("/x/Start.java"), "Start.java", java).mainClass)
    }

    @Test
    fun `the version of Kotlin is read from every kind of build file`() {
        val texts = mapOf(
            "build.gradle.kts" to
                "plugins {\n    // kotlin(\"jvm\") version \"1.0.0\"\n    kotlin(\"jvm\") version \"1.9.22\"\n}\nval lwjglVersion = \"3.3.3\"\n",
            "build.gradle" to "buildscript { ext.kotlin_version = '1.9.22' }\ndependencies { implementation \"org.lwjgl:lwjgl:3.3.3\" }\n",
            "gradle.properties" to "kotlinVersion=1.9.22\nlwjgl.version=3.3.3\n",
            "gradle/libs.versions.toml" to "[versions]\nkotlin = \"1.9.22\"\nlwjgl = \"3.3.3\"\n",
            "pom.xml" to "<properties><kotlin.version>1.9.22</kotlin.version><lwjgl.version>3.3.3</lwjgl.version></properties>",
        )
        for ((name, text) in texts) {
            assertEquals("1.9.22", Versions.kotlin(mapOf(Path.of(name) to text)), name)
        }
    }

    @Test
    fun `libraries are read from every kind of build file, those for tests are not`() {
        val gson = NamedLibrary("com.google.code.gson", "gson", "2.8.6")
        val openal = NamedLibrary("org.lwjgl", "lwjgl-openal", null)
        val script = """
            val gsonVersion = "2.8.6"
            dependencies {
                implementation(platform("org.lwjgl:lwjgl-bom:3.2.3"))
                // implementation("org.example:comment:1.0")
                testImplementation("junit:junit:4.13")
                for (module in listOf("lwjgl-openal")) implementation("org.lwjgl", module)
            """
        val texts = mapOf(
            "build.gradle.kts" to script + "    implementation(\"com.google.code.gson:gson:\$gsonVersion\")\n}",
            "build.gradle" to
                "api group: 'com.google.code.gson', name: 'gson', version: '2.8.6'\nimplementation \"org.lwjgl:lwjgl-openal\"",
            "a/build.gradle" to script + "    implementation(\"com.google.code.gson\", \"gson\", gsonVersion)\n}",
            "libs.versions.toml" to
                "[versions]\ngson = \"2.8.6\"\n[libraries]\ngson = { module = \"com.google.code.gson:gson\", version.ref = \"gson\" }\n" +
                "openal = { module = \"org.lwjgl:lwjgl-openal\" }",
            "pom.xml" to
                "<?xml version=\"1.0\"?><groupId>me</groupId><artifactId>tron</artifactId><gson.version>2.8.6</gson.version>" +
                "<dependency><groupId>com.google.code.gson</groupId><artifactId>gson</artifactId>" +
                "<version>\${gson.version}</version></dependency>" +
                "<dependency><groupId>org.lwjgl</groupId><artifactId>lwjgl-openal</artifactId></dependency>" +
                "<plugin><groupId>org.jetbrains.kotlin</groupId><artifactId>kotlin-maven-plugin</artifactId><version>2</version></plugin>",
        )
        for ((name, text) in texts) {
            val found = LibraryFinder.find(Versions.withoutComments(mapOf(Path.of(name) to text)).values)
            assertEquals(setOf(gson, openal), found.toSet(), name)
        }
    }

    @Test
    fun `the later edition is detected, and either can be asked for`() {
        val methods = "fun preTranslate(a: Float) { }\n fun rotate(a: Float) { }"
        val later = "package cga.exercise.components.geometry\nopen class Transformable { $methods }\n"
        val files = MadeUp.FILES + ("src/main/kotlin/cga/exercise/components/geometry/Transformable.kt" to later)
        val found = read(files).edition
        assertEquals("2022", found.edition.id)
        assertEquals(2.2, found.edition.gamma)
        assertEquals(2, found.evidence.size)
        assertEquals("2021", read(files, Edition.named("2021")).edition.edition.id)
        assertThrows(InputError::class.java) { Edition.named("1999") }
    }

    @Test
    fun `what is no submission is told why`() {
        assertRefused("no Kotlin or Java sources", mapOf("readme.txt" to "hello"))
        assertRefused("none of its 1 sources", mapOf("Main.kt" to "fun main() { }"))
        assertThrows(InputError::class.java) { SubmissionReader.read(folder.resolve("missing"), folder.resolve("x")) }
        val text = folder.resolve("notes.pdf").apply { writeText("%PDF") }
        assertTrue(
            "neither a folder" in
                assertThrows(NotASubmission::class.java) { SubmissionReader.read(text, folder.resolve("x")) }.message.orEmpty(),
        )
    }

    @Test
    fun `links are not followed`() {
        val outside = folder.resolve("outside").createDirectories()
        MadeUp.write(outside)
        val inside = folder.resolve("inside").createDirectories()
        inside.resolve("src").createSymbolicLinkPointingTo(outside.resolve("src"))
        assertThrows(NotASubmission::class.java) { SubmissionReader.read(inside, folder.resolve("x")) }
    }

    private fun assertRefused(reason: String, files: Map<String, String>) {
        val given = MadeUp.write(folder.resolve("given${files.hashCode()}"), files)
        val error = assertThrows(NotASubmission::class.java) { SubmissionReader.read(given, folder.resolve("unused")) }
        assertTrue(reason in error.message.orEmpty()) { error.message }
    }
}
