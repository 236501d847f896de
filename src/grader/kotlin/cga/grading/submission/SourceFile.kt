package cga.grading.submission

import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension

/**
 * A Kotlin or Java source file.
 *
 * @param path absolute.
 * @param name below the submission's root, with `/`.
 * @param text its contents; what is not UTF-8 in it is replaced.
 */
public class SourceFile(
    public val path: Path,
    public val name: String,
    public val text: String,
) {
    public val isKotlin: Boolean = path.name.endsWith(".kt", ignoreCase = true)

    /** Empty for the default package. */
    public val packageName: String = PACKAGE.find(text)?.groupValues?.get(1).orEmpty()

    /** The folder that the packages start in. */
    internal val sourceRoot: Path
        get() {
            val folder = path.parent
            val inside = Path.of(packageName.replace('.', '/'))
            if (packageName.isEmpty() || !folder.endsWith(inside)) return folder
            return generateSequence(folder) { it.parent }.elementAt(inside.nameCount)
        }

    /** The folder of the project that it belongs to: the source root without `src/main/kotlin` and its like. */
    internal val project: Path
        get() = generateSequence(sourceRoot) { it.parent }.first { it.name !in SOURCE_FOLDERS }

    /** The class that its `main` becomes part of, null where it has none. */
    internal val mainClass: String?
        get() {
            val main = (if (isKotlin) KOTLIN_MAIN else JAVA_MAIN).find(text) ?: return null
            val isTopLevel = isKotlin && main.value.trimStart('\n', '\r').first() !in " \t"
            val before = text.substring(0, main.range.first)
            // A companion's static main is its class's.
            val holder = if (isTopLevel) {
                null
            } else {
                HOLDER
                    .findAll(
                        before,
                    ).lastOrNull { it.groupValues[1] != "Companion" }
                    ?.groupValues
                    ?.get(1)
            }
            return listOf(packageName, holder ?: fileClass()).filter { it.isNotEmpty() }.joinToString(".")
        }

    private fun fileClass() =
        JVM_NAME.find(text)?.groupValues?.get(1)
            ?: (
                path.nameWithoutExtension
                    .replaceFirstChar(
                        Char::uppercaseChar,
                    ).map { if (it.isJavaIdentifierPart()) it else '_' }
                    .joinToString("") +
                    "Kt"
            )

    private companion object {
        val PACKAGE = Regex("""^\s*package\s+([\w.]+)""", RegexOption.MULTILINE)
        val KOTLIN_MAIN = Regex("""^[ \t]*(?:@JvmStatic\s+)?(?:public\s+)?(?:suspend\s+)?fun\s+main\s*\(""", RegexOption.MULTILINE)
        val JAVA_MAIN = Regex("""\bstatic\s+(?:final\s+)?void\s+main\s*\(""")
        val HOLDER = Regex("""\b(?:object|class|interface)\s+(\w+)""")
        val JVM_NAME = Regex("""^\s*@file\s*:\s*JvmName\s*\(\s*"(\w+)"""", RegexOption.MULTILINE)
        val SOURCE_FOLDERS = setOf("src", "main", "kotlin", "java")
    }
}
