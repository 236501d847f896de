package cga.grading.corpus

import cga.grading.findings.Place

/** The lines of [file] that a mistake has changed, [lines] counted from 1 as they are with it; where it took lines away the one behind. */
internal class EditedLines(
    val file: String,
    val lines: IntRange,
) {
    val isShader: Boolean get() = file.endsWith(".glsl") || file.endsWith(".frag") || file.endsWith(".vert")

    /** Whether [place] is one of them, or within three lines of one. */
    fun isAt(place: Place): Boolean = file.endsWith(place.file.trimStart('.', '/')) && place.line in lines.first - NEAR..lines.last + NEAR

    companion object {
        private const val NEAR = 3

        /** Every stretch of lines that is in [after] and not in [before], or the other way round. */
        fun between(
            before: Sources,
            after: Sources,
        ): List<EditedLines> =
            (before.keys + after.keys).distinct().flatMap { file ->
                val (old, new) = listOf(before, after).map { it[file]?.lines().orEmpty() }
                if (old == new) emptyList() else stretches(old, new).map { EditedLines(file, it) }
            }

        /** Where as many lines are left, those that differ; else all between what both begin and end with. */
        private fun stretches(
            old: List<String>,
            new: List<String>,
        ): List<IntRange> {
            if (old.size == new.size) return new.indices.filter { old[it] != new[it] }.map { it + 1..it + 1 }
            val same = old.zip(new).takeWhile { (a, b) -> a == b }.size
            val end = old.drop(same).asReversed().zip(new.drop(same).asReversed()).takeWhile { (a, b) -> a == b }.size
            return listOf(same + 1..maxOf(same + 1, new.size - end))
        }
    }
}
