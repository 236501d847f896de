package cga.inspect

import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.say
import cga.inspect.doctor.Finding

/** What the window has to say by itself: an error in a shader, why the picture is dark, that something was done. */
internal class Notices {
    /** The message of a shader that does not compile, or null. */
    var error: String? = null

    /** Likely causes of a dark picture; empty where it is not. */
    var findings: List<Finding> = emptyList()
    private var note = ""
    private var noteEnd = 0.0

    /** Says [text] for some [seconds] from [time] (seconds) on. */
    fun say(
        text: String,
        time: Double,
        seconds: Double = NOTE_SECONDS,
    ) {
        note = text
        noteEnd = time + seconds
    }

    /** Whether there is anything to draw at [time]. */
    fun isAny(time: Double): Boolean = error != null || findings.isNotEmpty() || time < noteEnd

    /** Draws them into a window of [width]×[height], beside a panel that takes [taken] on the right. */
    fun draw(
        ui: Ui,
        width: Float,
        height: Float,
        taken: Float,
    ) {
        val room = (width - taken - 2 * MARGIN).coerceIn(MIN_WIDTH, MAX_WIDTH)
        val error = error
        if (error != null) {
            drawError(ui, error, room, height)
        } else if (findings.isNotEmpty()) {
            drawFindings(ui, room, height)
        }
    }

    /** Draws what is said for a moment at [time], beside all panels: to be called after them. */
    fun drawNote(
        ui: Ui,
        width: Float,
        height: Float,
        time: Double,
    ) {
        if (time < noteEnd) ui.toast(note, width, height)
    }

    private fun drawError(
        ui: Ui,
        error: String,
        room: Float,
        height: Float,
    ) {
        val lines = error.lines().take(MAX_LINES)
        val tall = (lines + AGAIN).sum { ui.widgets.height(it, room) + GAP } + TITLE
        val title = say("The shader does not compile; the old one stays in use", "Der Shader lässt sich nicht übersetzen; der alte bleibt")
        ui.panel(title, MARGIN, MARGIN, room, minOf(tall, height - 2 * MARGIN)) {
            for (line in lines) paragraph(line, room, if (line.startsWith(SOURCE)) UiColor.WARNING else UiColor.ERROR)
            paragraph(AGAIN, room, UiColor.FAINT)
        }
    }

    private fun drawFindings(
        ui: Ui,
        room: Float,
        height: Float,
    ) {
        val shown = findings.take(MAX_FINDINGS)
        val tall = shown.sum { ui.widgets.height("1. ${it.found}", room) + ui.widgets.height(it.cure, room) + 2 * GAP } + TITLE + MORE
        val title = say("Dark? Likely causes, the likeliest first", "Dunkel? Mögliche Ursachen, die wahrscheinlichste zuerst")
        ui.panel(title, MARGIN, MARGIN, room, minOf(tall, height - 2 * MARGIN)) {
            for ((i, finding) in shown.withIndex()) {
                paragraph("${i + 1}. ${finding.found}", room, UiColor.WARNING)
                paragraph(finding.cure, room)
            }
            if (findings.size > shown.size) paragraph("and ${findings.size - shown.size} more: ./cga doctor --scene", room, UiColor.FAINT)
        }
    }

    private fun <T> List<T>.sum(of: (T) -> Float): Float = fold(0f) { sum, it -> sum + of(it) }

    private companion object {
        val AGAIN = say("Save the file again: it is read by itself.", "Nach dem Speichern wird die Datei neu gelesen.")
        const val NOTE_SECONDS = 2.5
        const val MARGIN = 14f
        const val GAP = 5f
        const val TITLE = 52f
        const val MORE = 24f
        const val SOURCE = "    "
        const val MIN_WIDTH = 220f
        const val MAX_WIDTH = 760f
        const val MAX_LINES = 14
        const val MAX_FINDINGS = 5
    }
}
