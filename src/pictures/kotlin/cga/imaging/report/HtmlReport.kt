package cga.imaging.report

import cga.framework.AtomicFile
import java.nio.file.Path

/** A page that shows every case of a compare: one HTML file that needs no other and no network. */
public object HtmlReport {
    /** Bytes that the pictures of a page may take. With more they are drawn smaller, the largest first, and it is said where. */
    private const val PICTURES_LIMIT = 9_000_000

    private const val MOST_REDUCTION = 16

    /** Writes the page on [cases] to [file], whole or not at all. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(
        title: String,
        cases: List<ReportCase>,
        file: Path,
    ) {
        AtomicFile.checkWritable(file)
        val sorted = cases.sortedByDescending { it.severity }.mapIndexed { i, case -> "case-${i + 1}" to case }
        // Compressing pictures is most of the work.
        val views = sorted.parallelStream().map { (id, case) -> CaseView(id, case) }.toList()
        shrinkTo(PICTURES_LIMIT, views)
        HtmlPage.write(title, file) {
            overview(views)
            views.forEach { case(it) }
        }
    }

    private fun shrinkTo(limit: Int, views: List<CaseView>) {
        while (views.sumOf { it.size } > limit) {
            val largest = views.maxBy { it.size }
            // So many cases that there is no end to it.
            if (largest.reduction >= MOST_REDUCTION) return
            largest.halve()
        }
    }
}
