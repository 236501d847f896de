package cga.grading.course

import cga.framework.InputError
import cga.framework.reason
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import cga.grading.findings.LogExcerpt
import cga.grading.findings.Outcome
import cga.grading.findings.Refused
import cga.grading.findings.RunFacts
import cga.grading.report.GradedSubmission
import java.io.IOException
import java.nio.file.Path
import java.util.Locale
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import kotlin.io.path.exists

/** Hears how a course goes on, from several threads, one call at a time. */
public interface CourseListener {
    /** [submission] is through. @param isNew false where its result was there already. */
    public fun finished(submission: GradedSubmission, isNew: Boolean)

    /** Something went wrong that cost no result: a page that could not be written. */
    public fun problem(message: String)
}

/** Grades many submissions, some at a time. Whatever happens to one costs only that one, and what is done stays done. */
public class CourseRun(
    private val store: ResultStore,
    private val grader: GradeOne,
    private val settings: CourseSettings,
    private val listener: CourseListener,
) {
    private val pages = SubmissionReports(settings)

    /** Submissions that an earlier run had begun and not ended. */
    public val interrupted: Set<String> get() =
        // A kill can come between a result and the line that says so.
        store.journal.interrupted().filterTo(linkedSetOf()) { !store.folder(it).resolve(OutcomeFile.NAME).exists() }

    /** Grades [submissions], takes over what is done, writes a page for each, and returns them in their order. */
    public fun run(submissions: List<Submission>, shard: Shard = Shard.WHOLE): List<GradedSubmission> {
        Manifest(shard, submissions.map { Manifest.Entry(it.name, it.folder) }).write(store.out)
        val workers = Executors.newFixedThreadPool(settings.jobs)
        try {
            val graded = workers.invokeAll(submissions.map { Callable { grade(it) } }).map { it.get() }
            return pages.withTwins(graded, listener)
        } catch (e: ExecutionException) {
            // Only what concerns all comes so far: the disk is full, the folder was removed.
            throw e.cause ?: e
        } finally {
            workers.shutdownNow()
        }
    }

    private fun grade(submission: Submission): GradedSubmission {
        val checksum = InputChecksum.of(submission.path, settings.fingerprint)
        val earlier = store.find(submission.folder, checksum)
        if (earlier != null) store.journal.add(Journal.KEPT, submission.folder)
        val stored =
            try {
                earlier ?: gradeNew(submission, checksum)
            } catch (e: IOException) {
                throw InputError("cannot keep the result of ${submission.name} in ${store.out} (${e.reason()}): is the disk full?", e)
            }
        val graded = GradedSubmission(submission.name, store.folder(submission.folder), stored.outcome, settings.rubric, stored.seconds)
        synchronized(listener) {
            pages.writeOrComplain(graded, listener)
            listener.finished(graded, isNew = earlier == null)
        }
        return graded
    }

    private fun gradeNew(submission: Submission, checksum: String): StoredOutcome {
        store.journal.add(Journal.START, submission.folder, "checksum" to checksum)
        val start = System.nanoTime()
        val staged = store.stage(submission.folder)

        fun stored(outcome: Outcome) = StoredOutcome(submission.name, checksum, (System.nanoTime() - start) / 1e9, outcome)
        val stored = keep(stored(measure(submission, staged)), staged) { stored(failed(it)) }
        val result = (stored.outcome as? Refused)?.reason?.id ?: "graded"
        store.journal.add(Journal.DONE, submission.folder, "result" to result, "seconds" to "%.3f".format(Locale.ROOT, stored.seconds))
        return stored
    }

    private fun measure(submission: Submission, staged: Path): Outcome =
        try {
            val partial = PartialResults(settings, listOf(staged.resolve(SubmissionReports.RESULTS)))
            grader.grade(submission.path, staged, partial)
        } catch (e: InterruptedException) {
            throw e
        } catch (e: Throwable) {
            // Also what an Error means: a stack that overflows on one submission is no reason to lose the others.
            failed(e)
        }

    /** Keeps [stored], or, where that cannot be kept, that this is so. */
    private fun keep(stored: StoredOutcome, staged: Path, instead: (Throwable) -> StoredOutcome): StoredOutcome {
        val complaint =
            try {
                store.commit(stored, staged)
                return stored
            } catch (e: IllegalArgumentException) {
                e
            } catch (e: InputError) {
                if (stored.outcome !is Graded) throw e
                e
            }
        return instead(complaint).also { store.commit(it, store.stage(staged.fileName.toString())) }
    }

    private fun failed(e: Throwable): Refused {
        val message = "${e.javaClass.name}: ${e.message.orEmpty()}".take(MOST_MESSAGE)
        val trace = e.stackTraceToString().take(MOST_TRACE)
        return Refused(FailureReason.INTERNAL, message, RunFacts(logs = listOf(LogExcerpt("grader", trace))))
    }

    private companion object {
        const val MOST_MESSAGE = 500
        const val MOST_TRACE = 20_000
    }
}
