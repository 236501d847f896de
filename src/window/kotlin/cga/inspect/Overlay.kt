package cga.inspect

import cga.framework.GameWindow
import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.UiInput
import cga.inspect.view.Look

/** All that lies over the picture: the panels, the window's own notices, the divider of the split view. Needs the OpenGL context. */
internal class Overlay(
    private val window: GameWindow,
    private val look: Look,
    private val notices: Notices,
    private val panel: ControlPanel,
) : AutoCloseable {
    private val ui = Ui(window.pixelRatio)
    private val width get() = window.framebufferWidth / window.pixelRatio
    private val height get() = window.framebufferHeight / window.pixelRatio

    /** The numbers of the pixel that was clicked. */
    val probe: ProbePanel = ProbePanel()

    /** Whether the panels are open; they have the keyboard and the mouse then. */
    var isOpen: Boolean = false
        set(value) {
            field = value
            if (!value) probe.show(null)
        }

    /** What the panels are told; null while they are closed. */
    val input: UiInput? get() = if (isOpen) ui.input else null

    /** Whether the keyboard writes a number. */
    val isTyping: Boolean get() = isOpen && ui.isTypingIn(ControlPanel.TITLE)

    /** Whether the mouse is over one of the panels. */
    val isMouseOver: Boolean get() = isOpen && ui.isOver(window.mousePos.xpos.toFloat(), window.mousePos.ypos.toFloat())

    /** Draws it as of [time] (seconds) into the window's framebuffer. */
    fun draw(time: Double) {
        if (!isOpen && !look.isSplit && !notices.isAny(time)) return
        ui.begin()
        if (look.isSplit) drawDivider()
        notices.draw(ui, width, height, if (isOpen) ControlPanel.TAKES else 0f, time)
        if (isOpen) {
            probe.draw(ui, width, height, window.pixelRatio)
            panel.draw(ui, width, height)
        }
        ui.end(width.toInt(), height.toInt())
    }

    private fun drawDivider() =
        ui.canvas("divider", width, height) {
            val x = look.divider * width
            val y = height / 2
            line(x, 0f, x, height, UiColor.DIVIDER)
            // What says that it can be dragged.
            for (side in SIDES) {
                line(x + side * NEAR, y - HALF, x + side * FAR, y, UiColor.DIVIDER)
                line(x + side * FAR, y, x + side * NEAR, y + HALF, UiColor.DIVIDER)
            }
            words(LEFT, x - GAP - wide(LEFT), GAP, UiColor.DIVIDER)
            words(RIGHT, x + GAP, GAP, UiColor.DIVIDER)
        }

    override fun close() {
        ui.close()
    }

    private companion object {
        const val LEFT = "Phong"
        const val RIGHT = "Blinn-Phong"
        const val GAP = 12f
        const val NEAR = 6f
        const val FAR = 13f
        const val HALF = 8f
        val SIDES = floatArrayOf(-1f, 1f)
    }
}
