package cga.coach.ui

import org.lwjgl.nuklear.NkColor
import org.lwjgl.nuklear.NkContext
import org.lwjgl.nuklear.NkRect
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.system.MemoryStack

/** Lines and words on a [Ui.canvas], straight over the picture. Lengths in window units, colours 0xRRGGBBAA. */
internal class Pencil(
    private val context: NkContext,
    private val font: UiFont,
) {
    fun line(
        x0: Float,
        y0: Float,
        x1: Float,
        y1: Float,
        color: Long,
        thickness: Float = THIN,
    ) {
        MemoryStack.stackPush().use { stack ->
            val canvas = nk_window_get_canvas(context) ?: return
            nk_stroke_line(canvas, x0, y0, x1, y1, thickness, UiStyle.set(NkColor.malloc(stack), color))
        }
    }

    /** [text] on a dark ground, with its upper left corner at ([x], [y]). */
    fun words(
        text: String,
        x: Float,
        y: Float,
        color: Long,
    ) {
        MemoryStack.stackPush().use { stack ->
            val canvas = nk_window_get_canvas(context) ?: return
            val width = wide(text)
            val background = UiStyle.set(NkColor.malloc(stack), UiColor.BACKDROP)
            val box = nk_rect(x - PADDING, y - PADDING, width + 2 * PADDING, UiFont.SIZE + 2 * PADDING, NkRect.malloc(stack))
            nk_fill_rect(canvas, box, PADDING, background)
            val bounds = nk_rect(x, y, width, UiFont.SIZE, NkRect.malloc(stack))
            nk_draw_text(canvas, bounds, text, font.handle, background, UiStyle.set(NkColor.malloc(stack), color))
        }
    }

    /** How wide [text] is. */
    fun wide(text: String): Float = font.width(text)

    private companion object {
        const val PADDING = 4f
        const val THIN = 1.5f
    }
}
