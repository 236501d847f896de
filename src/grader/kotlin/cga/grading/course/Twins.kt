package cga.grading.course

import cga.grading.findings.Part
import cga.grading.report.GradedSubmission

/** Finds submissions with parts that are the same once names and layout are taken away: for a person to look at, it costs nothing. */
internal object Twins {
    /** [submissions], each with what it shares with others. */
    fun marked(submissions: List<GradedSubmission>): List<GradedSubmission> {
        val groups = Part.entries.associateWith { part -> submissions.groupBy { it.outcome.facts.likeness.keys[part] } - null }
        return submissions.map { submission ->
            val twins = LinkedHashMap<String, MutableSet<Part>>()
            for ((part, key) in submission.outcome.facts.likeness.keys) {
                val others = groups.getValue(part)[key].orEmpty().filter { it !== submission }
                others.forEach { twins.getOrPut(it.name, ::linkedSetOf) += part }
            }
            submission.withTwins(twins)
        }
    }
}
