package cga.grading.corpus

import cga.grading.analysis.Analysis
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.util.zip.CRC32
import kotlin.io.path.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readLines
import kotlin.io.path.walk
import kotlin.io.path.writeText

/**
 * What this grader, as it is compiled now, has said of captures: written down as soon as it is said, so that a run that was broken off goes on
 * where it was. A changed grader begins anew.
 */
internal class SaidAlready(folder: Path) {
    private val file = folder.createDirectories().resolve("said-%08x.csv".format(fingerprint()))
    private val lines = if (file.exists()) file.readLines() else emptyList()
    private val said = lines.associateTo(HashMap()) { it.substringBefore(',') to it.substringAfter(',') }

    /** What was said of [capture]; null for nothing. */
    fun of(capture: Path): Judgement? = said[capture.name]?.let(Judgement::parse)

    /** Keeps what was said of [capture]. */
    fun note(
        capture: Path,
        judgement: Judgement,
    ) {
        said[capture.name] = judgement.line()
        file.writeText("${capture.name},${judgement.line()}\n", options = arrayOf(CREATE, APPEND))
    }

    /** Of the grader's classes and of what is expected of it, which are in two places. */
    private fun fingerprint(): Int {
        val places = listOf(Analysis::class.java, SaidAlready::class.java).map { Path(it.protectionDomain.codeSource.location.path) }
        val files = places.flatMap { place -> if (place.isRegularFile()) listOf(place) else place.walk().sorted().toList() }
        return CRC32().apply { files.forEach { update(it.readBytes()) } }.value.toInt()
    }
}
