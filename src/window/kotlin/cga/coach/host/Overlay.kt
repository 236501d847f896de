package cga.coach.host

import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.keys
import cga.coach.ui.say
import cga.framework.GameWindow

/** All that lies over the student's picture: what goes wrong, what is told for a moment, the panel, the keys. Needs the context. */
internal class Overlay(
    private val window: GameWindow,
    private val player: Player,
    private val look: CoachLook,
    private val panel: Panel,
) : AutoCloseable {
    private val ui = Ui(window.contentScale)
    private val state = GlState()
    private val width get() = window.framebufferWidth / window.contentScale
    private val height get() = window.framebufferHeight / window.contentScale

    /** Of the panels' units so many are one of the cursor's. */
    private val ratio get() = window.pixelRatio / window.contentScale
    private var note = ""
    private var noteEnd = 0.0

    /** What was wrong with the program that was to take the place of the one that plays, or null. */
    var complaint: Trouble? = null

    /** Whether a compiler is still at the first program. */
    var isWaiting = false

    /** Whether the mouse is over one of the panels. */
    val isMouseOver: Boolean get() = look.isOpen &&
        ui.isOver(window.mousePos.xpos.toFloat() * ratio, window.mousePos.ypos.toFloat() * ratio)

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
        if (look.isOpen) ui.input.move(x * ratio, y * ratio)
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
        val trouble = complaint ?: player.trouble ?: player.remarks.firstOrNull()
        val isSaying = time < noteEnd
        if (trouble == null && !isSaying && !look.isOpen && !look.showsKeys && !isWaiting) return
        state.read()
        GlState.setForPanels()
        ui.begin()
        val room = width - if (look.isOpen) Panel.TAKES else 0f
        if (trouble != null) draw(trouble, room)
        if (look.showsKeys) ui.keys(Keys.ALL, room, height)
        if (look.isOpen) panel.draw(ui, width, height)
        val waiting = say("Kotlin is compiled for the first time …", "Kotlin wird zum ersten Mal übersetzt …")
        if (isWaiting || isSaying) ui.toast(if (isWaiting) waiting else note, width, height)
        ui.end(width.toInt(), height.toInt())
        state.apply()
    }

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

    override fun close() {
        ui.close()
    }

    private companion object {
        const val START_SECONDS = 8.0
        const val NOTE_SECONDS = 2.5
        const val MARGIN = 14f
        const val GAP = 5f
        const val TITLE = 52f
        const val SOURCE = "    "
        const val MIN_WIDTH = 220f
        const val MAX_WIDTH = 760f
        const val MAX_LINES = 16
    }
}
