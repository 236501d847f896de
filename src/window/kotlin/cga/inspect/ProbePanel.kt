package cga.inspect

import cga.coach.ui.Columns
import cga.coach.ui.Pencil
import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.Widgets
import cga.inspect.probe.ProbeText
import cga.inspect.probe.Probed

/** The panel on the left with the numbers of the pixel that was clicked. */
internal class ProbePanel {
    private var text: ProbeText? = null
    private var probed: Probed? = null

    /** Shows [probed] from now on, or nothing. */
    fun show(probed: Probed?) {
        this.probed = probed
        text = probed?.let(::ProbeText)
    }

    /** Draws it into a window of [width]×[height], [ratio] pixels to a unit, with a cross at the pixel. */
    fun draw(
        ui: Ui,
        width: Float,
        height: Float,
        ratio: Float,
    ) {
        val probed = probed ?: return
        val text = text ?: return
        ui.canvas("cross", width, height) { cross((probed.column + 0.5f) / ratio, (probed.row + 0.5f) / ratio) }
        val tall = minOf(HEIGHT, height - 2 * MARGIN)
        ui.panel(TITLE, MARGIN, height - tall - MARGIN, WIDTH, tall) {
            row(1)
            label(text.where, UiColor.FAINT)
            line("reference (double)", text.expected, UiColor.GOOD)
            line("GPU (RGBA32F)", text.drawn, UiColor.GOOD)
            line("difference, at most", text.difference, if (probed.difference < NOTABLE) UiColor.GOOD else UiColor.WARNING)
            line("window (0–255)", text.shown, UiColor.TEXT)
            fold("Surface", false) { for (line in text.surface) line(line.name, line.value, UiColor.TEXT) }
            for ((i, light) in text.lights.withIndex()) {
                fold("probed ${light.first}", i == probed.look.light) {
                    for (line in light.second) line(line.name, line.value, UiColor.TEXT)
                }
            }
        }
    }

    private fun Widgets.line(
        name: String,
        value: String,
        color: Long,
    ) {
        row(PAIR)
        label(name, UiColor.FAINT)
        label(value, color, isRight = true)
    }

    private fun Pencil.cross(
        x: Float,
        y: Float,
    ) {
        // On a dark seam, so that it is seen on every picture.
        for ((color, thickness) in SEAMS) {
            line(x - LONG, y, x - SHORT, y, color, thickness)
            line(x + SHORT, y, x + LONG, y, color, thickness)
            line(x, y - LONG, x, y - SHORT, color, thickness)
            line(x, y + SHORT, x, y + LONG, color, thickness)
        }
    }

    private companion object {
        const val TITLE = "The numbers at a pixel"
        const val MARGIN = 7f
        const val WIDTH = 330f
        const val HEIGHT = 430f
        val PAIR = Columns(0.4f, 0.6f)
        const val LONG = 12f
        const val SHORT = 4f
        val SEAMS = listOf(UiColor.DARK to 5f, UiColor.WARNING to 2.5f)

        /** Steps of 255: more is no rounding. */
        const val NOTABLE = 1.0
    }
}
