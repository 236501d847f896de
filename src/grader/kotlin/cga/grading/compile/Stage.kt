package cga.grading.compile

import cga.grading.submission.SourceFile
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.name
import kotlin.io.path.writeText

/**
 * A submission's sources, laid out in [folder] for the compilers: the originals are not touched, and what is replaced is replaced here.
 */
internal class Stage(
    private val folder: Path,
    sources: List<SourceFile>,
    replacements: Map<String, String>,
) {
    val kotlin: Path = folder.resolve("kotlin").createDirectories()
    val java: Path = folder.resolve("java").createDirectories()
    val javaFiles: List<Path>

    /** What the Kotlin compiler is to read. */
    val folders: List<Path> get() = listOf(kotlin, java)
    val notes = mutableListOf<String>()

    /** Names below the submission's root by the names here. */
    private val names = HashMap<String, String>()

    init {
        val replaced = replacements.keys.associateWith { name -> sources.filter { it.declares(name) } }
        val kept = sources - replaced.values.flatten().toSet()
        kept.filter { it.isKotlin }.forEach { put(kotlin.resolve(it.name), it.text, it.name) }
        // The Kotlin compiler finds Java classes by their folders.
        javaFiles = kept.filterNot { it.isKotlin }.map { source ->
            val target = java.resolve(source.packageName.replace('.', '/')).resolve(source.path.name)
            put(target, source.text, source.name)
        }
        for ((name, text) in replacements) {
            put(
                kotlin.resolve("stand-in").resolve("${name.replace('.', '/')}.kt"),
                text,
                "${name.substringAfterLast('.')}.kt (our stand-in)",
            )
            if (replaced.getValue(name).isEmpty()) notes += "There is no class $name to be replaced."
            replaced.getValue(name).filter { it.text.lines().count(TOP_LEVEL::containsMatchIn) > 1 }.forEach {
                notes += "${it.name} declares more than $name, and is replaced as a whole."
            }
        }
    }

    private fun put(target: Path, text: String, name: String): Path {
        names["$target"] = name
        return target.createParentDirectories().apply { writeText(text) }
    }

    /** How the submission calls the file that a compiler, which runs in the folder above ours, calls [path]. */
    fun name(path: String): String = names["${folder.parent.resolve(path).normalize()}"] ?: path.substringAfterLast('/')

    private fun SourceFile.declares(qualified: String) =
        packageName == qualified.substringBeforeLast('.', "") &&
            Regex(
                """(?m)^[\w\s@()"]*\b(?:class|interface|object)\s+${Regex.escape(qualified.substringAfterLast('.'))}\b""",
            ).containsMatchIn(text)

    private companion object {
        val TOP_LEVEL = Regex("""^(?:[a-z]+\s+)*(?:class|interface|object)\s+\w""")
    }
}
