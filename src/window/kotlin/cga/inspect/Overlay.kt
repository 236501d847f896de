package cga.inspect

import cga.coach.ui.Ui
import cga.coach.ui.UiColor
import cga.coach.ui.UiInput
import cga.coach.ui.keys
import cga.framework.GameWindow
import cga.inspect.view.Look

/** All that lies over the picture: the panels, the window's own notices, the divider of the split view. Needs the OpenGL context. */
internal class Overlay(
    private val window: GameWindow,
    private val look: Look,
    private val notices: Notices,
    private val panel: ControlPanel,
    private val inspected: InspectedScene,
) : AutoCloseable {
    private val ui = Ui(window.contentScale)
    private val width get() = window.framebufferWidth / window.contentScale
    private val height get() = window.framebufferHeight / window.contentScale

    /** The numbers of the pixel that was clicked. */
    val probe: ProbePanel = ProbePanel()

    /** Whether the panels are open; they have the keyboard and the mouse then. */
    var isOpen: Boolean = false
        set(value) {
            field = value
            if (!value) probe.show(null)
        }

    /** Whether all keys are listed. */
    var showsKeys: Boolean = false

    /** Of the panels' units so many are one of the cursor's. */
    private val ratio get() = window.pixelRatio / window.contentScale

    /** The cursor is at ([x], [y]), in the window's coordinates. */
    fun move(
        x: Double,
        y: Double,
    ) {
        input?.move(x * ratio, y * ratio)
    }

    /** What the panels are told; null while they are closed. */
    val input: UiInput? get() = if (isOpen) ui.input else null

    /** Whether the keyboard writes a number. */
    val isTyping: Boolean get() = isOpen && ui.isTypingIn(ControlPanel.TITLE)

    /** Whether the mouse is over one of the panels. */
    val isMouseOver: Boolean get() = isOpen && ui.isOver(window.mousePos.xpos.toFloat() * ratio, window.mousePos.ypos.toFloat() * ratio)

    /** Draws it as of [time] (seconds) into the window's framebuffer. */
    fun draw(time: Double) {
        if (!isOpen && !showsKeys && !look.isSplit && !look.hasGizmos && !notices.isAny(time)) return
        ui.begin()
        if (look.hasGizmos) drawNames()
        if (look.isSplit) drawDivider()
        val taken = if (isOpen) ControlPanel.TAKES else 0f
        notices.draw(ui, width, height, taken)
        if (isOpen) {
            probe.draw(ui, width, height, window.contentScale)
            panel.draw(ui, width, height)
        }
        if (showsKeys) ui.keys(InspectedKeys.ALL, width - taken, height)
        notices.drawNote(ui, width, height, time)
        ui.end(width.toInt(), height.toInt())
    }

    private fun drawNames() =
        ui.canvas("names", width, height) {
            inspected.nameGizmos { name, place -> words(name, place.x() * width + GAP, place.y() * height, UiColor.TEXT) }
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
