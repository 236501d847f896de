package cga.coach.host

import cga.coach.numbers.Numbers
import cga.coach.numbers.Sent
import cga.coach.numbers.Sources
import cga.coach.ui.Columns
import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.Widgets
import cga.coach.ui.say

/** The panel on the right: what can be done, what is found of the tasks, and the numbers that the program sends. */
internal class Panel(
    private val player: Player,
    private val look: CoachLook,
    private val numbers: Numbers,
    private val sources: Sources,
    private val findings: () -> List<TaskFinding>,
) {
    fun draw(
        ui: Ui,
        width: Float,
        height: Float,
    ) {
        ui.panel(TITLE, width - WIDTH - MARGIN, MARGIN, WIDTH, height - 2 * MARGIN) {
            buttons()
            tasks()
            sources()
            numbers()
        }
    }

    private fun Widgets.buttons() {
        row(2)
        look.isPaused = checkbox(say("pause (P)", "Pause (P)"), look.isPaused)
        look.showsKeys = checkbox(say("keys (H)", "Tasten (H)"), look.showsKeys)
        row(2)
        if (button(say("reload (R)", "neu laden (R)"))) look.want(Wish.RELOAD)
        if (button(say("restart (F5)", "von vorn (F5)"))) look.want(Wish.RESTART)
        if (button(say("save picture (F12)", "Bild sichern (F12)"))) look.want(Wish.SCREENSHOT)
        if (button(say("close (Tab)", "schließen (Tab)"))) look.want(Wish.CLOSE)
        row(TWO)
        label(say("time", "Zeit"), UiColor.FAINT)
        label("%.1f s".format(player.inputs.time), isRight = true)
        label(say("OpenGL objects", "OpenGL-Objekte"), UiColor.FAINT)
        label("${player.objectCount}", isRight = true)
    }

    private fun Widgets.tasks() {
        val all = findings()
        if (all.isEmpty()) return
        fold(say("Tasks", "Aufgaben"), true) {
            for (task in all) {
                row(TASK)
                label(task.task, task.state.color)
                label(task.title)
                for (line in task.lines) paragraph(line, WIDTH, task.state.color)
            }
        }
    }

    private fun Widgets.sources() {
        fold(say("Colours that add up to the picture", "Farben, aus denen das Bild besteht"), true) {
            if (sources.all.isEmpty()) {
                val text = if (sources.isDone) say("None is sent.", "Es wird keine gesendet.") else say("looking …", "wird gesucht …")
                paragraph(text, WIDTH, UiColor.FAINT)
            }
            for (source in sources.all) {
                row(SOURCE)
                swatch(color(source))
                val isOn = source.scale != 0f
                if (checkbox(source.name, isOn) != isOn) source.scale = if (isOn) 0f else 1f
                if (button(say("alone", "allein"))) sources.solo(source)
            }
        }
    }

    private fun Widgets.numbers() {
        row(1)
        if (button(say("numbers as the program sends them", "Zahlen wie vom Programm gesendet"))) numbers.all.forEach(Sent::release)
        val groups = numbers.all.groupBy { it.name.substringBeforeLast('.', "") }
        for ((group, members) in groups) {
            fold(group.ifEmpty { say("Numbers that are sent", "Gesendete Zahlen") }, false) {
                for (sent in members) number(sent, sent.name.removePrefix("$group."))
            }
        }
    }

    private fun Widgets.number(
        sent: Sent,
        name: String,
    ) {
        row(1)
        val note = if (sent.varies) say(" (several in a picture)", " (mehrere je Bild)") else ""
        label(name + note, if (sent.isChanged) UiColor.WARNING else UiColor.FAINT)
        val high = sent.largest * ROOM
        for (i in 0 until sent.size) {
            row(NUMBER)
            label(if (sent.size == 1) "" else "${"xyzw"[i]}")
            val before = sent.value(i)
            val after = slider(before, if (sent.hasNegative) -high else 0f, high)
            if (after != before) sent.hold(i, after)
        }
    }

    /** As bright as a screen can show it. */
    private fun color(source: Sent): Long {
        val brightest = maxOf(source.values.max(), 1f)
        var rgba = 0L
        for (value in source.values) rgba = (rgba shl 8) or (value / brightest * 255).toLong().coerceIn(0, 255)
        return (rgba shl 8) or 0xFF
    }

    companion object {
        /** What it takes of the window, with the margin. */
        const val TAKES: Float = 334f
        const val TITLE: String = "Coach"
        private const val WIDTH = 320f
        private const val MARGIN = 7f

        /** So far beyond what has been seen a slider goes. */
        private const val ROOM = 2f
        private val TWO = Columns(0.6f, 0.4f)
        private val TASK = Columns(0.15f, 0.85f)
        private val SOURCE = Columns(0.08f, 0.68f, 0.24f)
        private val NUMBER = Columns(0.08f, 0.5f, 0.42f)
    }
}
