package cga.grading.submission

import java.nio.file.Path
import kotlin.io.path.name

/** Versions that a build file names, null where it names none. */
internal class Versions(
    val kotlin: String?,
    val lwjgl: String?,
    val joml: String?,
) {
    /** Reading them. */
    companion object {
        private const val NUMBER = """(\d++(?:\.\d++){1,5}+)"""

        private val SCRIPTS = setOf("build.gradle", "build.gradle.kts", "settings.gradle.kts")
        val FILES = SCRIPTS + setOf("gradle.properties", "libs.versions.toml", "pom.xml", "kotlinc.xml")

        private val KOTLIN = patterns(
            """kotlin\s*+\(\s*+["']jvm["']\s*+\)\s*+version\s*+\(?+\s*+["']$NUMBER""",
            """org\.jetbrains\.kotlin\.(?:jvm|multiplatform)["']\s*+\)?\s*+version\s*+\(?+\s*+["']$NUMBER""",
            """\bkotlin[._-]?[vV]ersion["']?\s*+[=,>]\s*+["']?$NUMBER""",
            """^[ \t]*+kotlin(?:-jvm)?\s*+=\s*+["']$NUMBER""",
            """kotlin-gradle-plugin:$NUMBER""",
            """kotlin-stdlib(?:-jdk\d)?:$NUMBER""",
            """name="version"\s+value="$NUMBER""",
        )
        private val LWJGL = library("lwjgl", "org.lwjgl:lwjgl(?:-\\w+)?")
        private val JOML = library("joml", "org.joml:joml(?:-\\w+)?")

        /** What [texts] (build files by path, the most telling first) say. No build script is run: this is only reading. */
        fun find(texts: Map<Path, String>): Versions {
            val plain = withoutComments(texts)

            fun first(patterns: List<Regex>) =
                plain.values.firstNotNullOfOrNull { text -> patterns.firstNotNullOfOrNull { it.find(text)?.groupValues?.get(1) } }
            return Versions(first(KOTLIN), first(LWJGL), first(JOML))
        }

        /** [texts] without lines that are comments of a script. */
        fun withoutComments(texts: Map<Path, String>): Map<Path, String> =
            texts.mapValues { (path, text) ->
                if (path.name.endsWith("gradle") || path.name.endsWith("kts")) text.replace(COMMENT, "") else text
            }

        private fun library(name: String, artifact: String) = patterns(
            """\b$name[._-]?[vV]ersion["']?\s*+[=,>]\s*+["']?$NUMBER""",
            """^[ \t]*+$name\s*+=\s*+["']$NUMBER""",
            """$artifact:$NUMBER""",
            """<artifactId>$name</artifactId>\s*+<version>$NUMBER""",
        )

        private fun patterns(vararg texts: String) = texts.map { Regex(it, RegexOption.MULTILINE) }

        private val COMMENT = Regex("""^[ \t]*+//.*+$""", RegexOption.MULTILINE)
    }
}
