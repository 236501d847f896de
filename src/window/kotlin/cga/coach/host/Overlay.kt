package cga.coach.host

import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.framework.GameWindow

/** All that lies over the student's picture: what goes wrong, what is told for a moment, the panel, the keys. Needs the context. */
internal class Overlay(
    private val window: GameWindow,
    private val player: Player,
    private val look: CoachLook,
    private val panel: Panel,
) : AutoCloseable {
    private val ui = Ui(window.pixelRatio)
    private val state = GlState()
    private val width get() = window.framebufferWidth / window.pixelRatio
    private val height get() = window.framebufferHeight / window.pixelRatio
    private var note = ""
    private var noteEnd = 0.0

    /** What was wrong with the program that was to take the place of the one that plays, or null. */
    var complaint: Trouble? = null

    /** Whether a compiler is still at the first program. */
    var isWaiting = false

    /** Whether the mouse is over one of the panels. */
    val isMouseOver: Boolean get() = look.isOpen && ui.isOver(window.mousePos.xpos.toFloat(), window.mousePos.ypos.toFloat())

    /** Says how everything else is found, from [time] (seconds) on. */
    fun start(time: Double) {
        note = say("Tab opens the panel · H shows all keys", "Tab öffnet die Tafel · H zeigt alle Tasten")
        noteEnd = time + START_SECONDS
    }

    /** Says [text] for a moment from [time] (seconds) on. */
    fun say(
        text: String,
        time: Double,
    ) {
        note = text
        noteEnd = time + NOTE_SECONDS
    }

    /** Hands a key to the panel and answers whether it is writing there. */
    fun key(
        key: Int,
        action: Int,
    ): Boolean {
        if (!look.isOpen) return false
        ui.input.key(key, action)
        return ui.isTypingIn(Panel.TITLE)
    }

    fun move(
        x: Double,
        y: Double,
    ) {
        if (look.isOpen) ui.input.move(x, y)
    }

    fun button(
        button: Int,
        action: Int,
    ) {
        ui.input.button(button, action)
    }

    fun scroll(
        x: Double,
        y: Double,
    ) {
        ui.input.scroll(x, y)
    }

    fun character(codePoint: Int) {
        if (look.isOpen) ui.input.character(codePoint)
    }

    /** Draws it as of [time] (seconds) into the window's framebuffer, and leaves everything else as it was. */
    fun draw(time: Double) {
        val trouble = complaint ?: player.trouble
        val isSaying = time < noteEnd
        if (trouble == null && !isSaying && !look.isOpen && !look.showsKeys && !isWaiting) return
        state.read()
        GlState.setForPanels()
        ui.begin()
        val room = width - if (look.isOpen) Panel.TAKES else 0f
        if (trouble != null) draw(trouble, room)
        if (look.showsKeys) drawKeys(room)
        if (look.isOpen) panel.draw(ui, width, height)
        // The last is on top.
        if (isWaiting) words("waiting", say("Kotlin is compiled for the first time …", "Kotlin wird zum ersten Mal übersetzt …"), height / 2)
        if (isSaying) words("note", note, height - NOTE_BELOW)
        ui.end(width.toInt(), height.toInt())
        state.apply()
    }

    private fun words(
        name: String,
        text: String,
        y: Float,
    ) = ui.canvas(name, width, height) { words(text, MARGIN + PADDING, y, UiColor.GOOD) }

    private fun draw(
        trouble: Trouble,
        room: Float,
    ) {
        val wide = (room - 2 * MARGIN).coerceIn(MIN_WIDTH, MAX_WIDTH)
        val lines = trouble.lines.flatMap { it.lines() }.take(MAX_LINES)
        val tall = (lines + trouble.cure).fold(TITLE) { sum, line -> sum + ui.widgets.height(line, wide) + GAP }
        ui.panel(trouble.title, MARGIN, MARGIN, wide, minOf(tall, height - 2 * MARGIN)) {
            for (line in lines) paragraph(line, wide, if (line.startsWith(SOURCE)) UiColor.WARNING else UiColor.ERROR)
            paragraph(trouble.cure, wide, UiColor.FAINT)
        }
    }

    private fun drawKeys(room: Float) {
        val wide = minOf(KEYS_WIDTH, room - 2 * MARGIN)
        val tall = TITLE + Keys.ALL.size * KEY_LINE
        ui.panel(say("Keys", "Tasten"), (room - wide) / 2, (height - tall) / 2, wide, tall) {
            for (key in Keys.ALL) {
                row(Keys.COLUMNS)
                label(key.name, UiColor.WARNING)
                label(key.effect)
            }
        }
    }

    override fun close() {
        ui.close()
    }

    private companion object {
        const val START_SECONDS = 8.0
        const val NOTE_SECONDS = 2.5
        const val NOTE_BELOW = 34f
        const val MARGIN = 14f
        const val PADDING = 10f
        const val GAP = 5f
        const val TITLE = 52f
        const val SOURCE = "    "
        const val MIN_WIDTH = 220f
        const val MAX_WIDTH = 760f
        const val MAX_LINES = 16
        const val KEYS_WIDTH = 560f
        const val KEY_LINE = 27f
    }
}
