package cga.grading.pipeline

import cga.framework.InputError
import cga.grading.findings.Findings
import cga.grading.findings.Place
import cga.grading.prepared.PreparedSource
import cga.grading.prepared.PreparedTree
import cga.grading.sandbox.SafeFiles

/** The source around the lines of Kotlin that findings name: a capture knows only the package and the file of a call. */
internal class Excerpts(private val tree: PreparedTree) {
    /** [findings] with the lines around every place that is in a source of the submission's own. */
    fun applied(findings: Findings): Findings = findings.with(findings.mistakes.map { it.at(it.places.map(::within)) })

    private fun within(place: Place): Place {
        if (place.source.isNotEmpty()) return place
        val source = source(place.file) ?: return place
        val text =
            try {
                SafeFiles.read(tree.folder, "${PreparedTree.SOURCES}/${source.file}", MOST_BYTES).decodeToString()
            } catch (_: InputError) {
                return place
            }
        return Place(source.name, place.line).within(text)
    }

    /** That whose path ends as the package says; Kotlin does not ask for that, so else the only one of its name. */
    private fun source(file: String): PreparedSource? {
        val own = tree.manifest.sources.filter { !it.isOurs }
        return own.find { "/${it.name}".endsWith("/$file") }
            ?: own.filter { it.name.substringAfterLast('/') == file.substringAfterLast('/') }.singleOrNull()
    }

    private companion object {
        const val MOST_BYTES = 1L shl 20
    }
}
