package cga.grading.course

import cga.grading.report.ContactSheet
import cga.grading.report.GradedSubmission
import cga.grading.report.GradesCsv
import cga.grading.report.JUnitXml
import cga.grading.report.Language
import java.nio.file.Path

/** What is written over all submissions: contact sheet, table, JUnit XML. */
public object CourseReport {
    /**
     * Writes `index.html`, `grades.csv` and `junit.xml` into [out]; [missing] are the names of submissions without a result. Throws
     * [cga.framework.InputError] when that is not possible.
     */
    public fun write(out: Path, submissions: List<GradedSubmission>, missing: List<String>, language: Language) {
        val sorted = submissions.sortedBy { it.folder.fileName.toString().lowercase() }
        GradesCsv.write(sorted, missing, out.resolve("grades.csv"))
        JUnitXml.write(sorted, language, out.resolve("junit.xml"))
        ContactSheet.write(sorted, missing, language, out.resolve("index.html"))
    }
}
