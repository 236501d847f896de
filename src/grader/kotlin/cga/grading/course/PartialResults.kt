package cga.grading.course

import cga.framework.InputError
import cga.grading.findings.Measured
import cga.grading.report.GradescopeResults
import java.nio.file.Path

/** Writes Gradescope's results after every check, so that there is something valid however the rest ends. */
internal class PartialResults(
    private val settings: CourseSettings,
    files: List<Path>,
) : CheckListener {
    private val files = files + listOfNotNull(settings.gradescope)
    private val start = System.nanoTime()
    private val checks = LinkedHashMap<String, Measured>()

    init {
        write()
    }

    @Synchronized
    override fun measured(check: Measured) {
        checks[check.check.id] = check
        write()
    }

    private fun write() {
        for (file in files) {
            try {
                val seconds = (System.nanoTime() - start) / 1e9
                GradescopeResults.writePartial(checks.values.toList(), settings.rubric, seconds, settings.language, file)
            } catch (_: InputError) {
                // It is for the case that nothing better comes; the whole results complain.
            }
        }
    }
}
