package cga.grading.submission

import java.nio.file.Path
import kotlin.io.path.name

/** Reads which version of Kotlin build files name. */
internal object Versions {
    private const val NUMBER = """(\d++(?:\.\d++){1,5}+)"""

    private val SCRIPTS = setOf("build.gradle", "build.gradle.kts", "settings.gradle.kts")
    val FILES = SCRIPTS + setOf("gradle.properties", "libs.versions.toml", "pom.xml", "kotlinc.xml")

    private val KOTLIN = listOf(
        """kotlin\s*+\(\s*+["']jvm["']\s*+\)\s*+version\s*+\(?+\s*+["']$NUMBER""",
        """org\.jetbrains\.kotlin\.(?:jvm|multiplatform)["']\s*+\)?\s*+version\s*+\(?+\s*+["']$NUMBER""",
        """\bkotlin[._-]?[vV]ersion["']?\s*+[=,>]\s*+["']?$NUMBER""",
        """^[ \t]*+kotlin(?:-jvm)?\s*+=\s*+["']$NUMBER""",
        """kotlin-gradle-plugin:$NUMBER""",
        """kotlin-stdlib(?:-jdk\d)?:$NUMBER""",
        """name="version"\s+value="$NUMBER""",
    ).map { Regex(it, RegexOption.MULTILINE) }

    /** What [texts] (build files by path, the most telling first) name. No build script is run: this is only reading. */
    fun kotlin(texts: Map<Path, String>): String? =
        withoutComments(texts).values.firstNotNullOfOrNull { text -> KOTLIN.firstNotNullOfOrNull { it.find(text)?.groupValues?.get(1) } }

    /** [texts] without lines that are comments of a script. */
    fun withoutComments(texts: Map<Path, String>): Map<Path, String> =
        texts.mapValues { (path, text) ->
            if (path.name.endsWith("gradle") || path.name.endsWith("kts")) text.replace(COMMENT, "") else text
        }

    private val COMMENT = Regex("""^[ \t]*+//.*+$""", RegexOption.MULTILINE)
}
