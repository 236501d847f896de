package cga.grading.corpus

import cga.grading.findings.Mistake
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readLines

/**
 * Reads a file of rewrites. tests/submissions/README.md describes the form.
 *
 * @param overlays folder of the folders that `overlay` names.
 */
internal class RewriteReader(private val overlays: Path) {
    /** The rewrites in [file]; throws [IllegalStateException] naming the line that is not understood. */
    fun read(file: Path): List<Rewrite> {
        val lines = file.readLines()
        val heads = lines.indices.filter { lines[it].startsWith("## ") }
        return heads.mapIndexed { i, head ->
            val end = heads.getOrNull(i + 1) ?: lines.size
            Section(file, head + 1).read(lines[head], lines.subList(head + 1, end))
        }
    }

    private inner class Section(
        private val file: Path,
        private val firstLine: Int,
    ) {
        private var title = ""
        private val without = HashSet<String>()
        private val with = ArrayList<String>()
        private val mistakes = ArrayList<Set<Mistake>>()
        private var costs: Set<String>? = null
        private var points: Double? = null
        private var base = Base.COURSE
        private val edits = ArrayList<Edit>()
        private var files = "*"
        private val find = ArrayList<String>()
        private val replacement = ArrayList<String>()

        fun read(
            head: String,
            body: List<String>,
        ): Rewrite {
            val (name, group) = HEAD.matchEntire(head)?.destructured ?: fail(0, head)
            body.forEachIndexed { i, line ->
                try {
                    read(line)
                } catch (e: IllegalStateException) {
                    fail(i + 1, "$line (${e.message})")
                }
            }
            endLines()
            val expectation = Expectation(mistakes, costs ?: (mistakes.flatten() - Mistake.UNKNOWN).map { it.check.id }.toSet(), points)
            return Rewrite(name, title, group, without, with, edits, expectation, file.nameWithoutExtension, base)
        }

        private fun read(line: String) {
            val (word, rest) = line.split(' ', limit = 2).let { it[0] to it.getOrElse(1) { "" } }
            if (word != "-" && word != "+") endLines()
            if (word == "-" && replacement.isNotEmpty()) endLines()
            when (word) {
                "" -> check(line.isBlank()) { "indented" }
                "-" -> find += rest
                "+" -> replacement += rest
                "~" -> edits += rest.pair(" ~> ") { find, fresh -> ReplaceText(files, find, fresh) }
                "in" -> files = rest
                "rename" -> edits += Rename(rest.words().associate { it.pair("=") { old, new -> old to new } })
                "overlay" -> edits += Overlay(overlays.resolve(rest))
                "root" -> edits += Nest(rest)
                "with" -> with += rest.words()
                "without" -> without += rest.words()
                "expect" -> mistakes += rest.words().map { names -> names.split('|').map(::mistake).toSet() }
                "points" -> points = rest.toDouble()
                "base" -> base = Base.valueOf(rest.uppercase())
                "costs" -> costs = rest.words().toSet()
                else -> title += if (title.isEmpty()) line else " $line"
            }
        }

        private fun endLines() {
            if (find.isEmpty() && replacement.isEmpty()) return
            check(find.isNotEmpty()) { "lines to add need a line that is there: write it with - and again with +" }
            edits += ReplaceLines(files, find.toList(), replacement.toList())
            find.clear()
            replacement.clear()
        }

        private fun mistake(id: String) = checkNotNull(Mistake.entries.find { it.id == id }) { "$id is no mistake" }

        private fun String.words() = split(' ').filter(String::isNotEmpty)

        private fun <T> String.pair(
            separator: String,
            make: (String, String) -> T,
        ): T {
            val parts = split(separator)
            check(parts.size == 2) { "not in two parts" }
            return make(parts[0], parts[1])
        }

        private fun fail(
            line: Int,
            text: String,
        ): Nothing = error("${file.fileName}:${firstLine + line}: $text")
    }

    private companion object {
        val HEAD = Regex("""## ([a-z0-9-]+)(?: \(([a-z0-9-]+)\))?""")
    }
}
