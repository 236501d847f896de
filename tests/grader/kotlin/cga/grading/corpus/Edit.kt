package cga.grading.corpus

import java.io.File
import java.nio.file.Path
import java.util.SortedMap
import java.util.TreeMap

/** The text files of a submission by their path, which is written with slashes. */
internal typealias Sources = SortedMap<String, String>

/** One change of a submission's sources. Where it does not apply, and apply just once, it throws [IllegalStateException]. */
internal sealed interface Edit {
    fun applyTo(sources: Sources)
}

/** Whole lines, looked for without their indentation, in the one file under [files] that has them; the new ones get the first one's. */
internal class ReplaceLines(
    private val files: String,
    private val find: List<String>,
    private val replacement: List<String>,
) : Edit {
    override fun applyTo(sources: Sources) {
        val wanted = find.map(String::trim)
        val places =
            sources.matching(files).flatMap { (path, text) ->
                val lines = text.lines()
                val starts = (0..lines.size - wanted.size).filter { at -> wanted.indices.all { lines[at + it].trim() == wanted[it] } }
                starts.map { path to it }
            }
        check(places.size == 1) { "${places.size} places have these lines, not one, in $files:\n${find.joinToString("\n")}" }
        val (path, at) = places.single()
        val lines = sources.getValue(path).lines()
        val indent = lines[at].takeWhile { it == ' ' }
        val fresh = replacement.map { if (it.isBlank()) "" else indent + it }
        sources[path] = (lines.take(at) + fresh + lines.drop(at + wanted.size)).joinToString("\n")
    }
}

/** A piece of text that stands once in the files under [files]. */
internal class ReplaceText(
    private val files: String,
    private val find: String,
    private val replacement: String,
) : Edit {
    override fun applyTo(sources: Sources) {
        val places = sources.matching(files).mapValues { (_, text) -> text.split(find).size - 1 }
        check(places.values.sum() == 1) { "${places.values.sum()} places have this text, not one, in $files: $find" }
        val path = places.entries.single { it.value == 1 }.key
        sources[path] = sources.getValue(path).replace(find, replacement)
    }
}

/** Words that get other words, all at the same time, in every Kotlin and GLSL file. Each must be there. */
internal class Rename(private val names: Map<String, String>) : Edit {
    override fun applyTo(sources: Sources) {
        val found = HashSet<String>()
        for ((path, text) in sources.toMap()) {
            if (path.substringAfterLast('.') !in CODE) continue
            sources[path] = WORD.replace(text) { word -> names[word.value]?.also { found += word.value } ?: word.value }
        }
        val missing = names.keys - found
        check(missing.isEmpty()) { "no file has the words $missing" }
        // A class that is called otherwise lives in a file of that name.
        for (path in sources.keys.toList()) {
            val name = path.substringAfterLast('/').substringBefore('.')
            val fresh = names[name] ?: continue
            sources[path.replace("/$name.", "/$fresh.")] = checkNotNull(sources.remove(path))
        }
    }

    private companion object {
        val CODE = setOf("kt", "glsl")
        val WORD = Regex("[A-Za-z_][A-Za-z0-9_]*")
    }
}

/** Every file under [folder] comes in the place of its like, or beside the others. */
internal class Overlay(private val folder: Path) : Edit {
    override fun applyTo(sources: Sources) {
        sources += readSources(folder).also { check(it.isNotEmpty()) { "$folder holds no files" } }
    }
}

/** The whole project goes into [folder]. */
internal class Nest(private val folder: String) : Edit {
    override fun applyTo(sources: Sources) {
        val moved = sources.mapKeys { "$folder/${it.key}" }
        sources.clear()
        sources += moved
    }
}

/** All files below [folder], as text. */
internal fun readSources(folder: Path): Sources {
    val root = folder.toFile()
    val files = root.walk().filter(File::isFile)
    return TreeMap(files.associate { it.relativeTo(root).invariantSeparatorsPath to it.readText() })
}

/** The files whose path ends with [pattern], in which `*` is anything. */
private fun Sources.matching(pattern: String): Map<String, String> {
    val regex = Regex(".*" + pattern.split('*').joinToString(".*") { Regex.escape(it) })
    return filterKeys(regex::matches)
}
