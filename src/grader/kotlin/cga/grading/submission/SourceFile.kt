package cga.grading.submission

import cga.grading.likeness.CodeShape
import cga.grading.prepared.PreparedSource
import java.nio.file.Path
import kotlin.io.path.name

/**
 * A Kotlin or Java source file.
 *
 * @param path absolute.
 * @param name below the submission's root, with `/`.
 * @param text its contents; what is not UTF-8 in it is replaced.
 */
internal class SourceFile(
    val path: Path,
    val name: String,
    val text: String,
) {
    val isKotlin: Boolean = path.name.endsWith(".kt", ignoreCase = true)

    private val parts = SourceText(text)

    /** What its string literals say, as it is written there. */
    val literals: Collection<String> get() = parts.literals.values

    /** What is left of it without names and layout. */
    val shape: String get() = CodeShape.of(parts.code, optional = ";,", without = setOf("package", "import"))

    /** Empty for the default package, and where what stands there is none. */
    val packageName: String =
        PACKAGE.find(parts.code)?.groupValues?.get(1)?.replace("`", "")?.takeIf { it.split('.').none(String::isEmpty) }.orEmpty()

    /** The folder that the packages start in. */
    val sourceRoot: Path
        get() {
            val folder = path.parent
            val inside = Path.of(packageName.replace('.', '/'))
            if (packageName.isEmpty() || !folder.endsWith(inside)) return folder
            return generateSequence(folder) { it.parent }.elementAt(inside.nameCount)
        }

    /** The folder of the project that it belongs to: the source root without `src/main/kotlin` and its like. */
    val project: Path
        get() = generateSequence(sourceRoot) { it.parent }.first { it.name !in SOURCE_FOLDERS }

    /** The class that its `main` becomes part of, null where it has none. */
    val mainClass: String? by lazy {
        val main = (if (isKotlin) KOTLIN_MAIN else JAVA_MAIN).find(parts.code)
        val isTopLevel = isKotlin && main != null && main.value.first() !in " \t"
        // A companion's static main is its class's.
        val holder = if (main == null || isTopLevel) null else classes(main.range.first).lastOrNull { it != "Companion" }
        main?.let { listOf(packageName, holder ?: fileClass()).filter { it.isNotEmpty() }.joinToString(".") }
    }

    private fun classes(before: Int) = HOLDER.findAll(parts.code).takeWhile { it.range.first < before }.map { it.groupValues[1] }

    /** Whether it declares the class [name]. */
    fun declares(name: String): Boolean = HOLDER.findAll(parts.code).any { it.groupValues[1] == name }

    /** How many classes it declares at the beginning of a line. */
    val topLevelClasses: Int get() = TOP_LEVEL.findAll(parts.code).count()

    /** The class of what lies in no class: the compiler sees the plain name. */
    private fun fileClass() = jvmName() ?: (PreparedSource.stem(path.name).replaceFirstChar(Char::uppercaseChar) + "Kt")

    private fun jvmName(): String? = JVM_NAME.find(parts.code)?.let { parts.literals[it.range.last + 1] }

    private companion object {
        // None of them looks at a line, or at the blanks between two words, more than once.
        val PACKAGE = Regex("""^[ \t]*+package[ \t]++([\w.`]++)""", RegexOption.MULTILINE)
        val KOTLIN_MAIN =
            Regex("""^[ \t]*+(?:@JvmStatic\s++)?+(?:public\s++)?+(?:suspend\s++)?+fun\s++main\s*+\(""", RegexOption.MULTILINE)
        val JAVA_MAIN = Regex("""\bstatic\s++(?:final\s++)?+void\s++main\s*+\(""")
        val HOLDER = Regex("""\b(?:object|class|interface)\s++(\w++)""")
        val TOP_LEVEL = Regex("""^(?:[a-z][a-z \t]*[ \t])?(?:class|interface|object)[ \t]++\w""", RegexOption.MULTILINE)
        val JVM_NAME = Regex("""^[ \t]*+@file\s*+:\s*+JvmName\s*+\(\s*+"""", RegexOption.MULTILINE)
        val SOURCE_FOLDERS = setOf("src", "main", "kotlin", "java")
    }
}
