package cga.coach.host

import cga.coach.ui.Columns
import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.Widgets

/** The panel on the right: what is done, what can be done, and the numbers that the program sends. */
internal class Panel(
    private val player: Player,
    private val look: CoachLook,
) {
    fun draw(
        ui: Ui,
        width: Float,
        height: Float,
    ) {
        ui.panel(TITLE, width - WIDTH - MARGIN, MARGIN, WIDTH, height - 2 * MARGIN) {
            buttons()
            figures()
        }
    }

    private fun Widgets.buttons() {
        row(2)
        look.isPaused = checkbox(say("pause (P)", "Pause (P)"), look.isPaused)
        look.showsKeys = checkbox(say("keys (H)", "Tasten (H)"), look.showsKeys)
        row(THREE)
        if (button(say("reload (R)", "neu laden (R)"))) look.want(Wish.RELOAD)
        if (button(say("restart (F5)", "von vorn (F5)"))) look.want(Wish.RESTART)
        if (button(say("picture (F12)", "Bild (F12)"))) look.want(Wish.SCREENSHOT)
    }

    private fun Widgets.figures() {
        row(TWO)
        label(say("time", "Zeit"), UiColor.FAINT)
        label("%.1f s".format(player.inputs.time), isRight = true)
        label(say("OpenGL objects", "OpenGL-Objekte"), UiColor.FAINT)
        label("${player.objectCount}", isRight = true)
    }

    companion object {
        /** What it takes of the window, with the margin. */
        const val TAKES: Float = 334f
        private const val WIDTH = 320f
        private const val MARGIN = 7f
        const val TITLE: String = "Coach"
        private val TWO = Columns(0.6f, 0.4f)
        private val THREE = Columns(0.34f, 0.33f, 0.33f)
    }
}
