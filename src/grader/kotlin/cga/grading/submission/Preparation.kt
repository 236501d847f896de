package cga.grading.submission

import cga.grading.findings.Likeness
import cga.grading.prepared.Edition
import cga.grading.prepared.Prepared
import cga.grading.prepared.PreparedSource
import cga.grading.prepared.PreparedTree
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.name
import kotlin.io.path.writeText

/** Makes a plain tree of what was handed in: its sources under names of ours, what can take their places, and the folder to start it in. */
internal object Preparation {
    private const val WINDOW = "GameWindow"
    private const val FRAMEWORK = "cga.framework"

    /** Reads [given] and fills [folder], which is empty. Throws [NotASubmission], [Unreadable] or [NoRoom]. */
    fun prepare(given: Path, folder: Path, edition: Edition?): Prepared {
        val submission = SubmissionReader.read(given, folder.resolve("unpacked"), edition)
        if (submission.sources.size >=
            PreparedTree.MOST_SOURCES
        ) {
            throw NotASubmission("it has more than ${PreparedTree.MOST_SOURCES} sources.")
        }
        val notes = mutableListOf<String>()
        val sources = sources(submission, folder, notes)
        val start = RunFolder(submission, folder.resolve(PreparedTree.START))
        val prepared = Prepared(
            submission.kind,
            submission.edition.edition,
            submission.mainClass?.takeIf(PreparedTree::isClass),
            submission.kotlin?.takeIf(PreparedTree::isCoordinate),
            submission.libraries,
            sources,
            submission.notes + notes + start.notes,
            key(submission.sources),
        )
        PreparedTree.write(prepared, folder)
        return prepared
    }

    /** What was given out with the sheet is everybody's. */
    private fun key(sources: List<SourceFile>): String? {
        val own = sources.filterNot { "${it.packageName}.".startsWith("$FRAMEWORK.") }.map { it.shape }.filter(String::isNotEmpty)
        return if (own.isEmpty()) null else Likeness.keyOf(own.map(String::toByteArray))
    }

    /** Our window takes the place of the submission's; the file that has it is replaced as a whole. */
    private fun sources(submission: Submission, folder: Path, notes: MutableList<String>): List<PreparedSource> {
        val (own, reference) = listOf(PreparedTree.SOURCES, PreparedTree.REFERENCE).map { folder.resolve(it).createDirectories() }
        val (replaced, kept) = submission.sources.partition { it.packageName == FRAMEWORK && it.declares(WINDOW) }
        if (replaced.isEmpty()) notes += "There is no class $FRAMEWORK.$WINDOW to be replaced."
        for (file in replaced.filter { it.topLevelClasses > 1 }) {
            notes +=
                "${file.name} declares more than $FRAMEWORK.$WINDOW, and is replaced as a whole."
        }
        val sources = kept.mapIndexed { index, source ->
            val instead = ReferenceSources.like(source, submission.kind)
            PreparedSource(source.name, PreparedSource.place(index, source.path.name), hasReference = instead != null).also {
                own.resolve(it.file).createParentDirectories().writeText(source.text)
                instead?.let { text -> reference.resolve(it.file).createParentDirectories().writeText(text) }
            }
        }
        val window = PreparedSource("$WINDOW.kt (our stand-in)", PreparedSource.place(sources.size, "$WINDOW.kt"), isOurs = true)
        val text = StandIn(replaced.firstOrNull()?.text).source()
        own.resolve(window.file).createParentDirectories().writeText(text)
        return sources + window
    }
}
