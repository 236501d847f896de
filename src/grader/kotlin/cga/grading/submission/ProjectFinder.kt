package cga.grading.submission

import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name

/** Finds the one project in a [tree] that holds more than that: copies, other exercises, halves of it in modules. */
internal class ProjectFinder(
    private val tree: FileTree,
) {
    val notes = mutableListOf<String>()

    private class Candidate(val folder: Path, val sources: List<SourceFile>) {
        val hasMain = sources.any { it.mainClass != null && "Game(" in it.text }
        val isBackup = folder.any { BACKUP.containsMatchIn(it.name) }

        /** Which of the course's two halves it has. */
        val halves = HALVES.filter { half -> sources.any { it.packageName.startsWith(half) } }
        val names = sources.mapTo(HashSet()) { it.packageName to it.path.name }
    }

    /** The sources of the project. Throws [NotASubmission] where there is none. */
    fun sources(): List<SourceFile> {
        val all = tree.files
            .filter { it.extension.lowercase() in setOf("kt", "java") }
            .mapNotNull { path -> tree.text(path)?.let { SourceFile(path, tree.name(path), it) } }
        if (all.isEmpty()) throw NotASubmission("there are no Kotlin or Java sources in it.")
        val candidates = all.groupBy { it.project }.map { Candidate(it.key, it.value) }
        val best = candidates.filter { it.halves.isNotEmpty() }.maxWithOrNull(ORDER)
            ?: throw NotASubmission("none of its ${all.size} sources is in a package cga.exercise or cga.framework.")
        val others = candidates - best
        val modules = modules(best, others.filter { it.halves.isNotEmpty() })
        for (left in others - modules.toSet()) {
            if (left.halves.isNotEmpty()) {
                notes +=
                    "${label(left.folder)} holds another copy of the project, which is not graded; ${label(best.folder)} is."
            }
        }
        // What lies in no package of the course but inside the project, such as helpers in a source folder of their own; no other program.
        val inside = others.filter { other ->
            val isProgram = best.hasMain && other.sources.any { it.mainClass != null }
            other.halves.isEmpty() && other.folder.startsWith(best.folder) && !other.isBackup && !isProgram
        }
        return (listOf(best) + modules + inside).flatMap { it.sources }.sortedBy { it.name }
    }

    /** A project may be cut into modules: others that have the half that [best] lacks, and nothing twice. */
    private fun modules(best: Candidate, others: List<Candidate>): List<Candidate> {
        if (best.halves.size == HALVES.size) return emptyList()
        return others
            .filter {
                it.halves != best.halves && !it.isBackup && it.names.none(best.names::contains)
            }.sortedWith(ORDER.reversed())
            .take(1)
    }

    private fun label(folder: Path) = tree.name(folder).ifEmpty { "the folder itself" }

    private companion object {
        val HALVES = listOf("cga.exercise", "cga.framework")
        val BACKUP = Regex("""(?i)(?:^|[\W_])(?:backup|bak|old|alt|copy|kopie|archiv|vorlage|template)(?:$|[\W_\d])""")

        /** The best last: a project that can be started, is no copy by its name, is whole, is large, lies high. */
        val ORDER: Comparator<Candidate> =
            compareBy({
                !it.isBackup
            }, { it.hasMain }, { it.halves.size }, { it.sources.size }, { -it.folder.nameCount }, { "${it.folder}" })
    }
}
