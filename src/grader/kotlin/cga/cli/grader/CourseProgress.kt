package cga.cli.grader

import cga.grading.course.CourseListener
import cga.grading.course.Eta
import cga.grading.report.GradedSubmission
import com.github.ajalt.mordant.animation.progress.ThreadProgressTaskAnimator
import com.github.ajalt.mordant.animation.progress.animateOnThread
import com.github.ajalt.mordant.animation.progress.execute
import com.github.ajalt.mordant.terminal.Terminal
import com.github.ajalt.mordant.widgets.progress.completed
import com.github.ajalt.mordant.widgets.progress.progressBar
import com.github.ajalt.mordant.widgets.progress.progressBarContextLayout
import com.github.ajalt.mordant.widgets.progress.text
import java.util.Locale

/**
 * How far a course is: a bar where this is a terminal, else a line for each submission, so that a log of CI shows it as well.
 *
 * @param total submissions to come; 0 shows nothing but problems.
 */
internal class CourseProgress(
    private val terminal: Terminal,
    private val total: Int,
    jobs: Int,
) : CourseListener,
    AutoCloseable {
    private val eta = Eta(jobs)
    private val problems = mutableListOf<String>()
    private var done = 0
    private var earlier = 0
    private val bar = if (total > 0 && terminal.terminalInfo.outputInteractive) bar() else null
    private val drawing = bar?.execute()

    private fun bar(): ThreadProgressTaskAnimator<String> =
        progressBarContextLayout<String> {
            text("grading")
            progressBar()
            completed()
            text { context }
        }.animateOnThread(terminal, context = eta.words(total), total = total.toLong())

    /** Says what an earlier run left. */
    fun resuming(interrupted: Set<String>) {
        if (interrupted.isNotEmpty()) say("interrupted last time, and done again now: ${interrupted.joinToString()}")
    }

    override fun finished(submission: GradedSubmission, isNew: Boolean) {
        done++
        if (isNew) eta.add(submission.seconds) else earlier++
        if (total == 0) return
        val words = eta.words(total - done)
        val animator = bar
        if (animator == null) {
            say("[$done/$total] ${line(submission)}${if (isNew) "" else ", done before"}; $words")
        } else {
            animator.update {
                completed = done.toLong()
                context = words
            }
        }
    }

    override fun problem(message: String) {
        problems += message
    }

    private fun line(submission: GradedSubmission): String {
        val points = submission.points?.let { "%.1f of %.1f".format(Locale.ROOT, it, submission.rubric.total).replace(".0", "") }
        val result = submission.refusal?.reason?.id ?: points
        return "${submission.folder.fileName}: $result (${"%.1f".format(Locale.ROOT, submission.seconds)} s)"
    }

    private fun say(text: String) = terminal.println(text, stderr = true)

    override fun close() {
        // It ends by itself when all is completed, its last state drawn.
        if (done == total) drawing?.get() else bar?.stop()
        problems.forEach(::say)
    }
}
