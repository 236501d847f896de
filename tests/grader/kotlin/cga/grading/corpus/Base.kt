package cga.grading.corpus

import cga.grading.starter.StarterFiles
import cga.grading.starter.StarterLanguage
import cga.grading.starter.Template
import java.util.TreeMap

/** What a submission of the corpus is rewritten from. */
internal enum class Base {
    /** The course's project, solved: `tests/submissions/course`. */
    COURSE,

    /** This project's starter as it is handed out. */
    STARTER,

    /** The starter with every gap filled in. */
    SOLUTION,
    ;

    /** Its text files by their path. */
    fun sources(): Sources =
        when (this) {
            COURSE -> Corpus.course
            STARTER -> TreeMap(templates.mapValues { it.value.starter }.filterValues { it.isNotBlank() } + main)
            SOLUTION -> TreeMap(templates.mapValues { (_, it) -> Template.solution(it.starter, it.regions) } + main)
        }

    private companion object {
        const val MAIN = "src/main/kotlin/cga/exercise/Main.kt"
        val templates: Map<String, Template> by lazy { StarterFiles(StarterLanguage.ENGLISH).templates() }
        val main: Pair<String, String> by lazy { MAIN to StarterFiles(StarterLanguage.ENGLISH).all().getValue(MAIN).decodeToString() }
    }
}
