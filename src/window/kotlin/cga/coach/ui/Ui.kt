package cga.coach.ui

import org.lwjgl.nuklear.NkAllocator
import org.lwjgl.nuklear.NkBuffer
import org.lwjgl.nuklear.NkColor
import org.lwjgl.nuklear.NkContext
import org.lwjgl.nuklear.NkRect
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil

/**
 * Panels over the scene, made anew for every picture: [begin], the panels' contents, [end]. All lengths in window units from the upper
 * left corner. Made and used with an OpenGL context current.
 *
 * @param pixelRatio framebuffer pixels a window unit.
 */
internal class Ui(private val pixelRatio: Float) : AutoCloseable {
    private val allocator =
        NkAllocator
            .calloc()
            .alloc { _, _, size -> MemoryUtil.nmemAllocChecked(size) }
            .mfree { _, memory -> MemoryUtil.nmemFree(memory) }
    private val font = UiFont(allocator, pixelRatio)
    private val context = NkContext.calloc()
    private val commands = NkBuffer.calloc()
    private val painter: UiPainter

    /** Left, top, width, height of each panel. */
    private val places = FloatArray(4 * MAX_PANELS)
    private var panels = 0

    /** What the keyboard and the mouse tell the panels. */
    val input: UiInput = UiInput(context)

    /** What a panel is filled with. */
    val widgets: Widgets = Widgets(context, font)

    /** What a canvas is drawn on with. */
    val pencil: Pencil = Pencil(context, font)

    init {
        check(nk_init(context, allocator, font.handle)) { "Nuklear does not start" }
        nk_buffer_init(commands, allocator, 1 shl 14)
        UiStyle.apply(context)
        painter = UiPainter(context, commands, font)
        nk_input_begin(context)
    }

    /** Whether the point ([x], [y]) is on one of the panels of the last picture. */
    fun isOver(
        x: Float,
        y: Float,
    ): Boolean =
        (0 until panels step 4).any { i ->
            x >= places[i] && y >= places[i + 1] && x < places[i] + places[i + 2] && y < places[i + 1] + places[i + 3]
        }

    /** Whether the keyboard writes a number in the panel [title]. */
    fun isTypingIn(title: String): Boolean {
        val number = nk_window_find(context, title)?.property() ?: return false
        return number.active() != 0 && number.state() == PROPERTY_EDITED
    }

    /**
     * Writes [text] at the lower edge of the window of [width]×[height], where none of this picture's panels is: to be called after all of them.
     * A canvas lies below panels.
     */
    fun toast(
        text: String,
        width: Float,
        height: Float,
    ) = canvas("toast", width, height) {
        val wide = wide(text)
        val (x, y) = PLACES
            .map { (across, up) -> EDGE + (width - wide - 2 * EDGE).coerceAtLeast(0f) * across to height - up }
            .let { places -> places.firstOrNull { (x, y) -> isFree(x, y, wide) } ?: places.first() }
        words(text, x, y, UiColor.GOOD)
    }

    private fun isFree(
        x: Float,
        y: Float,
        wide: Float,
    ): Boolean =
        (0 until panels step 4).none { i ->
            x < places[i] + places[i + 2] && x + wide > places[i] && y < places[i + 1] + places[i + 3] && y + UiFont.SIZE > places[i + 1]
        }

    /** Starts a picture's panels. */
    fun begin() {
        nk_input_end(context)
        panels = 0
    }

    /**
     * A panel at ([x], [y]) with the size [width]×[height]; its [content] is left out while it is folded.
     *
     * @param title also its name, one for each panel.
     */
    inline fun panel(
        title: String,
        x: Float,
        y: Float,
        width: Float,
        height: Float,
        content: Widgets.() -> Unit,
    ) {
        if (start(title, x, y, width, height)) widgets.content()
        finish()
    }

    fun start(
        title: String,
        x: Float,
        y: Float,
        width: Float,
        height: Float,
    ): Boolean {
        val flags = NK_WINDOW_TITLE or NK_WINDOW_MINIMIZABLE or NK_WINDOW_BORDER
        remember(x, y, width, if (nk_window_is_collapsed(context, title)) FOLDED else height)
        return MemoryStack.stackPush().use { stack ->
            val bounds = nk_rect(x, y, width, height, NkRect.malloc(stack))
            // Placed by the window's size, and not by the user: nothing is lost when the window shrinks.
            nk_window_set_bounds(context, title, bounds)
            nk_begin(context, title, bounds, flags).also { widgets.typed = nk_window_find(context, title)?.property() }
        }
    }

    private fun remember(
        x: Float,
        y: Float,
        width: Float,
        height: Float,
    ) {
        if (panels + 4 > places.size) return
        places[panels++] = x
        places[panels++] = y
        places[panels++] = width
        places[panels++] = height
    }

    fun finish() {
        nk_end(context)
    }

    /** Draws lines and words without a panel, over the whole window of [width]×[height]; of one [name] there is one in a picture. */
    inline fun canvas(
        name: String,
        width: Float,
        height: Float,
        draw: Pencil.() -> Unit,
    ) {
        MemoryStack.stackPush().use { stack ->
            val clear = NkColor.calloc(stack)
            nk_style_push_color(context, context.style().window().fixed_background().data().color(), clear)
            val flags = NK_WINDOW_BACKGROUND or NK_WINDOW_NO_INPUT or NK_WINDOW_NO_SCROLLBAR
            if (nk_begin(context, name, nk_rect(0f, 0f, width, height, NkRect.malloc(stack)), flags)) pencil.draw()
            nk_end(context)
            nk_style_pop_color(context)
        }
    }

    /** Draws the panels over the picture that is there, in a window of [width]×[height]. */
    fun end(
        width: Int,
        height: Int,
    ) {
        painter.paint(width, height, pixelRatio)
        nk_input_begin(context)
    }

    override fun close() {
        painter.close()
        nk_free(context)
        nk_buffer_free(commands)
        font.close()
        context.free()
        commands.free()
        allocator.alloc()?.free()
        allocator.mfree()?.free()
        allocator.free()
    }

    private companion object {
        /** Nuklear's own NK_PROPERTY_EDIT, which it does not tell. */
        const val PROPERTY_EDITED = 1
        const val MAX_PANELS = 8

        /** Height of a panel of which only the title bar is there. */
        const val FOLDED = 34f
        const val EDGE = 24f

        /** Where a toast may be: as a share of the width, and from the lower edge. */
        val PLACES = listOf(0f to 34f, 0.5f to 34f, 1f to 34f, 0f to 64f, 0.5f to 64f)
    }
}
