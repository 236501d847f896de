package cga.grading.starter

import cga.exercise.components.shader.ShaderSource
import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/** The files of the starter: the solution's own, cut, and the few that make a project of them. Throws [InputError] where one is missing. */
public object StarterFiles {
    /** Name of the file that tells a starter from any other project. */
    public const val MARKER: String = ".cga-starter"

    /** What it begins with: the number changes when a filled-in starter must be graded otherwise. */
    public const val VERSION_LINE: String = "cga-starter 1"

    /** Where the sources lie, and what lies before their packages in our project and in the starter. */
    private val SOURCES = listOf("$OURS/cga/framework", "$OURS/cga/exercise", "shaders")
    private const val OURS = "src/scene/kotlin"
    private const val THEIRS = "src/main/kotlin"
    private const val CATALOGUE = "gradle/libs.versions.toml"

    // The window's inspector shows the factors of the formula, which are the exercise.
    private const val INSPECTOR = "shaders/inspect/"
    private val SOURCE_TYPES = setOf("kt", "vert", "frag")
    private val MODEL_TYPES = setOf("obj", "mtl", "png")

    /** What is copied as it is from the top of the project: where a starter is made these must be there. */
    internal val COPIES: List<String> =
        listOf("LICENSE", "gradlew", "gradlew.bat", CATALOGUE, "gradle/wrapper/gradle-wrapper.jar") +
            "gradle/wrapper/gradle-wrapper.properties"

    /** Written for the starter alone; they lie beside this class. */
    private val OWN =
        mapOf(
            "README.md" to "README.md",
            "build.gradle.kts" to "build.gradle.kts",
            "settings.gradle.kts" to "settings.gradle.kts",
            "pom.xml" to "pom.xml",
            "$THEIRS/cga/exercise/Main.kt" to "Main.kt",
            ".gitignore" to "gitignore",
        )

    /** The sources that students write in or read, by their path in the starter. */
    public fun templates(): Map<String, Template> =
        SOURCES.flatMap { below(it, SOURCE_TYPES) }.associate { path ->
            path.replace(Regex("^$OURS/"), "$THEIRS/") to Template(path, source(path))
        }

    /** What shaders include is put into them: students read one plain file. */
    private fun source(path: String): String =
        if (path.startsWith("shaders/")) {
            ShaderSource.read(path).text
        } else {
            Home.read(path, "source").decodeToString().replace("\r\n", "\n")
        }

    /** Every file of the starter, by its path. */
    public fun all(): Map<String, ByteArray> = all { it.starter }

    /** The same with nothing cut out: the starter as somebody fills it in who does everything right. */
    internal fun solution(): Map<String, ByteArray> = all { it.solution }

    private fun all(text: (Template) -> String): Map<String, ByteArray> {
        val sources = templates().mapValues { (_, template) -> text(template).encodeToByteArray() }
        val copies = (COPIES + below("assets", MODEL_TYPES)).associateWith { Home.read(it, "project") }
        val written = mapOf(CATALOGUE to catalogue(), MARKER to "$VERSION_LINE\n").mapValues { it.value.encodeToByteArray() }
        return sources + copies + OWN.mapValues { own(it.value) } + written
    }

    /** Our catalogue with what the starter's build uses: the grader fetches what a submission that does not compile names. */
    private fun catalogue(): String {
        val script = own("build.gradle.kts").decodeToString()
        val libraries = Home.read(CATALOGUE, "project").decodeToString().replace("\r\n", "\n").replace(LIBRARY) { entry ->
            val alias = entry.groupValues[1].replace('-', '.')
            if (Regex("""\blibs\.${Regex.escape(alias)}\b""") in script) entry.value else ""
        }
        return libraries.replace(VERSION) { entry ->
            val name = entry.groupValues[1]
            if ("version.ref = \"$name\"" in libraries || "libs.versions.$name." in script) entry.value else ""
        }
    }

    // Each with the comment above it.
    private val LIBRARY = Regex("""(?m)(?:^#.*\n)*^([\w-]+) = \{ module.*\n""")
    private val VERSION = Regex("""(?m)^(\w+) = ".*\n""")

    private fun below(
        folder: String,
        types: Set<String>,
    ): List<String> {
        val home = Home.resolve("")
        val start = Home.resolve(folder)
        if (!start.isDirectory()) throw InputError("the folder $start does not exist: the starter is made where the project's sources are.")
        val files = start.walk().filter { it.extension in types && !Files.isHidden(it) }.map { it.name(home) }
        return files.filterNot { it.startsWith(INSPECTOR) }.sorted().toList()
    }

    private fun Path.name(home: Path) = toAbsolutePath().relativeTo(home.toAbsolutePath()).invariantSeparatorsPathString

    private fun own(name: String): ByteArray {
        val resource = StarterFiles::class.java.getResourceAsStream(name) ?: error("the program lacks its file $name")
        val content = resource.use { it.readBytes() }
        return if (name == "pom.xml") withVersions(content.decodeToString()).encodeToByteArray() else content
    }

    /** Maven cannot read the catalogue of versions: `@lwjgl@` in [pom] becomes what it says of `lwjgl`. */
    private fun withVersions(pom: String): String {
        val versions = Home.read(CATALOGUE, "project").decodeToString().substringAfter("[versions]").substringBefore("\n[")
        return Regex("@(\\w+)@").replace(pom) { match ->
            val name = match.groupValues[1]
            val version = Regex("""(?m)^$name = "(.+)"""").find(versions) ?: throw InputError("$CATALOGUE: there is no version $name.")
            version.groupValues[1]
        }
    }
}
