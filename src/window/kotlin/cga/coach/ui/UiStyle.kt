package cga.coach.ui

import org.lwjgl.nuklear.NkColor
import org.lwjgl.nuklear.NkContext
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.system.MemoryStack

/** The panels' colours: dark and a little transparent, so that the scene stays in sight, with one accent. */
internal object UiStyle {
    private const val TEXT = 0xE6E8ECFFL
    private const val PANEL = 0x10141CE6L
    private const val HEADER = 0x1C2430F2L
    private const val BORDER = 0x3A4658FFL
    private const val FIELD = 0x2A3342FFL
    private const val HOVER = 0x38455AFFL
    private const val ACCENT = 0x37C871FFL
    private const val BRIGHT = 0x5BE495FFL

    private val COLORS =
        mapOf<Int, Long>(
            NK_COLOR_TEXT to TEXT,
            NK_COLOR_WINDOW to PANEL,
            NK_COLOR_HEADER to HEADER,
            NK_COLOR_BORDER to BORDER,
            NK_COLOR_BUTTON to FIELD,
            NK_COLOR_BUTTON_HOVER to HOVER,
            NK_COLOR_BUTTON_ACTIVE to ACCENT,
            NK_COLOR_TOGGLE to FIELD,
            NK_COLOR_TOGGLE_HOVER to HOVER,
            NK_COLOR_TOGGLE_CURSOR to ACCENT,
            NK_COLOR_SELECT to FIELD,
            NK_COLOR_SELECT_ACTIVE to ACCENT,
            NK_COLOR_SLIDER to FIELD,
            NK_COLOR_SLIDER_CURSOR to ACCENT,
            NK_COLOR_SLIDER_CURSOR_HOVER to BRIGHT,
            NK_COLOR_SLIDER_CURSOR_ACTIVE to BRIGHT,
            NK_COLOR_PROPERTY to FIELD,
            NK_COLOR_EDIT to FIELD,
            NK_COLOR_EDIT_CURSOR to TEXT,
            NK_COLOR_COMBO to FIELD,
            NK_COLOR_CHART to FIELD,
            NK_COLOR_CHART_COLOR to ACCENT,
            NK_COLOR_CHART_COLOR_HIGHLIGHT to BRIGHT,
            NK_COLOR_SCROLLBAR to HEADER,
            NK_COLOR_SCROLLBAR_CURSOR to HOVER,
            NK_COLOR_SCROLLBAR_CURSOR_HOVER to HOVER,
            NK_COLOR_SCROLLBAR_CURSOR_ACTIVE to ACCENT,
            NK_COLOR_TAB_HEADER to HEADER,
        )

    /** Gives [context] these colours. */
    fun apply(context: NkContext) {
        MemoryStack.stackPush().use { stack ->
            val table = NkColor.calloc(NK_COLOR_COUNT, stack)
            for (i in 0 until NK_COLOR_COUNT) set(table[i], COLORS[i] ?: FIELD)
            nk_style_from_table(context, table)
        }
    }

    /** Sets [color] to the number 0xRRGGBBAA. */
    fun set(
        color: NkColor,
        rgba: Long,
    ): NkColor =
        color.set(
            (rgba shr 24 and 0xFF).toByte(),
            (rgba shr 16 and 0xFF).toByte(),
            (rgba shr 8 and 0xFF).toByte(),
            (rgba and 0xFF).toByte(),
        )
}
