package cga.grading.starter

import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/**
 * The files of the starter: the project in `src/starter`, which is the course's way to solve the sheet, cut; models, textures and the build
 * tool's own; and the window as a library. Throws [InputError] where one is missing.
 *
 * @param language of the tasks and of what students read.
 */
public class StarterFiles(
    private val language: StarterLanguage,
) {
    /** The sources that students write in or read, by their path in the starter. */
    public fun templates(): Map<String, Template> =
        below(PROJECT) { it.extension in SOURCE_TYPES }.associate { path ->
            path.removePrefix("$PROJECT/") to Template(path, text(path), language)
        }

    /** Every file of the starter, by its path. */
    public fun all(): Map<String, ByteArray> = all { it.starter }

    /** The same with nothing cut out: the starter as somebody fills it in who does everything right. */
    internal fun solution(): Map<String, ByteArray> = all { it.solution }

    private fun all(text: (Template) -> String): Map<String, ByteArray> {
        val sources = templates().mapValues { (_, template) -> text(template) }.filterValues { it.isNotBlank() }
        val written = mapOf(CATALOGUE to catalogue(), MARKER to "$VERSION_LINE\nlanguage ${language.code}\n") + sources
        val own = below(PROJECT) { it.extension !in SOURCE_TYPES }.mapNotNull { path ->
            name(path.removePrefix("$PROJECT/"))?.let { it to withVersions(it, Home.read(path, "project")) }
        }
        val copies = (COPIES + below("assets") { it.extension in MODEL_TYPES }).associateWith { Home.read(it, "project") }
        return copies + own + written.mapValues { it.value.encodeToByteArray() } + CoachJars.all()
    }

    /** What [path] is called in the starter; null for what belongs to the other language or to us. */
    private fun name(path: String): String? =
        when (path) {
            "gitignore" -> ".gitignore"
            "README.${language.code}.md" -> "README.md"
            else -> path.takeIf { !it.startsWith("README.") }
        }

    private fun text(path: String) = Home.read(path, "source").decodeToString().replace("\r\n", "\n")

    /** Our catalogue with what the starter's build uses: the grader fetches what a submission that does not compile names. */
    private fun catalogue(): String {
        val script = text("$PROJECT/build.gradle.kts")
        val libraries = text(CATALOGUE).replace(LIBRARY) { entry ->
            val alias = entry.groupValues[1].replace('-', '.')
            if (Regex("""\blibs\.${Regex.escape(alias)}\b""") in script) entry.value else ""
        }
        return libraries.replace(VERSION) { entry ->
            val name = entry.groupValues[1]
            if ("version.ref = \"$name\"" in libraries || "libs.versions.$name." in script) entry.value else ""
        }
    }

    private fun below(folder: String, isWanted: (Path) -> Boolean): List<String> {
        val home = Home.resolve("")
        val start = Home.resolve(folder)
        if (!start.isDirectory()) throw InputError("the folder $start does not exist: the starter is made where the project's sources are.")
        val files = start.walk().filter { it.isRegularFile() && !Files.isHidden(it) && isWanted(it) }
        return files.map { it.toAbsolutePath().relativeTo(home.toAbsolutePath()).invariantSeparatorsPathString }.sorted().toList()
    }

    /** Maven cannot read the catalogue of versions: `@lwjgl@` in its file becomes what it says of `lwjgl`. */
    private fun withVersions(name: String, content: ByteArray): ByteArray {
        if (!name.endsWith("pom.xml")) return content
        val versions = text(CATALOGUE).substringAfter("[versions]").substringBefore("\n[")
        return Regex("@(\\w+)@")
            .replace(content.decodeToString()) { match ->
                val wanted = match.groupValues[1]
                val version =
                    Regex("""(?m)^$wanted = "(.+)"""").find(versions) ?: throw InputError("$CATALOGUE: there is no version $wanted.")
                version.groupValues[1]
            }.encodeToByteArray()
    }

    public companion object {
        /** Name of the file that tells a starter from any other project. */
        public const val MARKER: String = ".cga-starter"

        /** What it begins with: the number changes when a filled-in starter must be graded otherwise. */
        public const val VERSION_LINE: String = "cga-starter 2"

        private const val PROJECT = "src/starter"
        private const val CATALOGUE = "gradle/libs.versions.toml"
        private val SOURCE_TYPES = setOf("kt", "glsl")
        private val MODEL_TYPES = setOf("obj", "mtl", "png")

        // Each with the comment above it.
        private val LIBRARY = Regex("""(?m)(?:^#.*\n)*^([\w-]+) = \{ module.*\n""")
        private val VERSION = Regex("""(?m)^(\w+) = ".*\n""")

        /** What is copied as it is from the top of the project: where a starter is made these must be there. */
        internal val COPIES: List<String> =
            listOf("LICENSE", "gradlew", "gradlew.bat", CATALOGUE, "gradle/wrapper/gradle-wrapper.jar") +
                "gradle/wrapper/gradle-wrapper.properties"
    }
}

/** A language that students are spoken to in. */
public enum class StarterLanguage(
    public val code: String,
) {
    ENGLISH("en"),
    GERMAN("de"),
}
