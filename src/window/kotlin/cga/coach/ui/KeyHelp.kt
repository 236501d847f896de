package cga.coach.ui

/** A key, or several, and what it does. */
internal class KeyHelp(
    val name: String,
    val effect: String,
)

/** A panel with all [keys], in the middle of [room] beside other panels, in a window of [height]. */
internal fun Ui.keys(
    keys: List<KeyHelp>,
    room: Float,
    height: Float,
) {
    val wide = minOf(WIDTH, room - 2 * EDGE)
    val tall = minOf(TITLE + keys.size * LINE, height - 2 * EDGE)
    panel(say("Keys", "Tasten"), (room - wide) / 2, (height - tall) / 2, wide, tall) {
        for (key in keys) {
            row(COLUMNS)
            label(key.name, UiColor.WARNING)
            label(key.effect)
        }
    }
}

private const val WIDTH = 600f
private const val EDGE = 14f
private const val TITLE = 52f
private const val LINE = 27f
private val COLUMNS = Columns(0.22f, 0.78f)
