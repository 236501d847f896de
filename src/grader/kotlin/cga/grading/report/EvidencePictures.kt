package cga.grading.report

import cga.framework.InputError
import cga.framework.image.ImageData
import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.findings.Findings
import cga.grading.findings.Mistake
import cga.imaging.BytePicture
import cga.imaging.PictureFile
import cga.imaging.report.EmbeddedPicture
import java.nio.file.Path

/**
 * One piece of evidence with its pictures made ready; [expected] is null where there is none, or none of the same size.
 *
 * @param own what [measured] is called.
 */
internal class EvidenceView(
    val evidence: Evidence,
    val own: String,
    val measured: EmbeddedPicture,
    val expected: EmbeddedPicture?,
)

/** The pictures of a submission, read from its [folder] and shrunk to what a page can carry. A picture that cannot be read costs only itself. */
internal class EvidencePictures(
    private val folder: Path,
    findings: Findings,
    private val messages: Messages,
) {
    /** Whether some of the reference's files had a part in drawing them. */
    val areRepaired: Boolean = findings.mistakes.any { it.mistake == Mistake.KOTLIN_REFUSED }
    private val own = messages.text(if (areRepaired) "page.repaired" else "page.yours")
    private val broken = mutableListOf<String>()
    private val views = findings.pictures.mapIndexedNotNull { i, evidence -> view("picture-$i", evidence) }
    private val charged = findings.mistakes.map { it.mistake.check }.toSet()

    /** The whole picture, beside what it should be where that is known. */
    val main: List<EvidenceView> get() = views.filter { it.evidence.check == null }.sortedBy { it.expected == null }

    /** What proves the mistake that costs [check]. */
    fun proofs(check: Check): List<EvidenceView> = views.filter { it.evidence.check == check }

    /** All that belong to a check and prove no mistake. */
    val others: List<EvidenceView> get() = views.filter { it.evidence.check != null && it.evidence.check !in charged }

    /** What the reader has to know of the pictures. */
    val complaints: List<String>

    init {
        val all = views.flatMap { listOfNotNull(it.measured, it.expected) }
        while (all.sumOf { it.size } > LIMIT) {
            val largest = all.maxBy { it.size }
            if (largest.reduction >= MOST_REDUCTION) break
            // Both of a pair, so that they can lie upon each other.
            views.filter { it.measured == largest || it.expected == largest }.forEach {
                it.measured.halve()
                it.expected?.halve()
            }
        }
        val smaller = if (all.any { it.reduction > 1 }) listOf(messages.text("page.smaller")) else emptyList()
        complaints = broken.map { messages.text("page.picture-broken", it) } + smaller
    }

    private fun view(id: String, evidence: Evidence): EvidenceView? {
        val measured = read(evidence.measured) ?: return null
        val expected = evidence.expected?.let(::read)?.takeIf { it.width == measured.width && it.height == measured.height }
        val title = cleanLine(messages.say(evidence.title))
        return EvidenceView(
            evidence,
            own,
            EmbeddedPicture("$id-measured", "$title, $own", measured),
            expected?.let { EmbeddedPicture("$id-expected", "$title, ${messages.text("page.expected")}", it) },
        )
    }

    private fun read(name: String): ImageData? =
        try {
            (PictureFile.read(folder.resolve(name)) as? BytePicture)?.image
        } catch (_: InputError) {
            null
        }.also { if (it == null) broken += name }

    private companion object {
        /** Bytes that the pictures of a page may take. */
        const val LIMIT = 5_000_000
        const val MOST_REDUCTION = 16
    }
}
