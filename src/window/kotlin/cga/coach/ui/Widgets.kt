package cga.coach.ui

import org.lwjgl.BufferUtils
import org.lwjgl.nuklear.NkColor
import org.lwjgl.nuklear.NkContext
import org.lwjgl.nuklear.NkPropertyState
import org.lwjgl.nuklear.NkRect
import org.lwjgl.nuklear.NkVec2
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.system.MemoryStack
import java.nio.FloatBuffer
import kotlin.math.ceil

/** Shares of a panel's width, 1 in all. Kept by who uses them: Nuklear looks at them again while the row is filled. */
internal class Columns(vararg shares: Float) {
    val shares: FloatBuffer = BufferUtils.createFloatBuffer(shares.size).put(shares).flip()
}

/** The things that a panel is made of, from top to bottom. Those that change a value return the new one. Colours are 0xRRGGBBAA. */
internal class Widgets(
    private val context: NkContext,
    private val font: UiFont,
) {
    private val number = FloatArray(1)

    /** Which number is being typed in the panel that is filled now; set by [Ui]. */
    var typed: NkPropertyState? = null
    private val digits = Digits()
    private val folded = HashMap<String, IntArray>()

    /** The next widgets stand side by side, [columns] a row. */
    fun row(
        columns: Int,
        height: Float = LINE,
    ) {
        nk_layout_row_dynamic(context, height, columns)
    }

    /** As [row], in [columns] of different width. */
    fun row(columns: Columns) {
        nk_layout_row(context, NK_DYNAMIC, LINE, columns.shares)
    }

    fun label(
        text: String,
        color: Long = UiColor.TEXT,
        isRight: Boolean = false,
    ) {
        MemoryStack.stackPush().use { stack ->
            val align = if (isRight) NK_TEXT_RIGHT else NK_TEXT_LEFT
            nk_label_colored(context, text, align, UiStyle.set(NkColor.malloc(stack), color))
        }
    }

    /** A paragraph in a row of its own, broken into the lines that it needs in a panel of [width]. */
    fun paragraph(
        text: String,
        width: Float,
        color: Long = UiColor.TEXT,
    ) {
        row(1, height(text, width))
        MemoryStack.stackPush().use { stack -> nk_label_colored_wrap(context, text, UiStyle.set(NkColor.malloc(stack), color)) }
    }

    /** How high a [paragraph] is. Words are not broken, so its lines are a little shorter than the panel. */
    fun height(
        text: String,
        width: Float,
    ): Float = ceil(font.width(text) / ((width - EDGES) * FILLED)).coerceAtLeast(1f) * TEXT_LINE + 2

    fun button(text: String): Boolean = nk_button_label(context, text)

    fun checkbox(
        text: String,
        isOn: Boolean,
    ): Boolean = nk_check_label(context, text, isOn)

    /** One of several that exclude each other; true when it is chosen now. */
    fun option(
        text: String,
        isOn: Boolean,
    ): Boolean = nk_option_label(context, text, isOn) && !isOn

    /** A list that unfolds: the number of the chosen one of [names]. */
    fun choice(
        names: List<String>,
        chosen: Int,
    ): Int {
        var answer = chosen
        MemoryStack.stackPush().use { stack ->
            val size = NkVec2.malloc(stack).set(nk_widget_width(context), (names.size * (LINE + 4) + 12).coerceAtMost(MAX_LIST))
            if (nk_combo_begin_label(context, names[chosen], size)) {
                row(1)
                for (i in names.indices) if (nk_combo_item_label(context, names[i], NK_TEXT_LEFT)) answer = i
                nk_combo_end(context)
            }
        }
        return answer
    }

    /** A slider, and beside it the number, which can be typed; two widgets. */
    fun slider(
        value: Float,
        min: Float,
        max: Float,
    ): Float {
        number[0] = value.coerceIn(min, max)
        nk_slider_float(context, min, number, max, (max - min) / SLIDER_STEPS)
        val step = (max - min) / 100
        property(min, max, step)
        // What was out of range stays as it is until somebody moves it.
        return if (number[0] == value.coerceIn(min, max)) value else number[0]
    }

    /** Nuklear writes two digits after the point and cuts the others off: so what it has written is written over, unless it is being typed. */
    private fun property(
        min: Float,
        max: Float,
        step: Float,
    ) {
        MemoryStack.stackPush().use { stack ->
            val bounds = nk_widget_bounds(context, NkRect.malloc(stack))
            val typed = typed
            val name = nk_murmur_hash(NUMBER, typed?.seq() ?: 0)
            nk_property_float(context, "#", min, number, max, step, step / 4)
            val isTyped = typed != null && typed.active() != 0 && typed.name() == name
            val canvas = nk_window_get_canvas(context)
            if (isTyped || canvas == null) return
            val text = digits.of(number[0])
            val inside = nk_rect(bounds.x() + LINE, bounds.y() + 1, bounds.w() - 2 * LINE, bounds.h() - 2, NkRect.malloc(stack))
            val field = context.style().property().normal().data().color()
            nk_fill_rect(canvas, inside, 0f, field)
            val width = font.width(text)
            val place = nk_rect(inside.x() + (inside.w() - width) / 2, inside.y() + TEXT_TOP, width, UiFont.SIZE, NkRect.malloc(stack))
            nk_draw_text(canvas, place, text, font.handle, field, UiStyle.set(NkColor.malloc(stack), UiColor.TEXT))
        }
    }

    /** A part that folds by a click on its [title]. */
    inline fun fold(
        title: String,
        isOpen: Boolean,
        content: () -> Unit,
    ) {
        if (unfolded(title, isOpen)) {
            content()
            nk_tree_state_pop(context)
        }
    }

    fun unfolded(
        title: String,
        isOpen: Boolean,
    ): Boolean {
        val state = folded.getOrPut(title) { intArrayOf(if (isOpen) NK_MAXIMIZED else NK_MINIMIZED) }
        return nk_tree_state_push(context, NK_TREE_TAB, title, state)
    }

    fun unfoldEnd(): Unit = nk_tree_state_pop(context)

    /** A rectangle of colour, as wide as its column. */
    fun swatch(color: Long) {
        MemoryStack.stackPush().use { stack ->
            val bounds = NkRect.malloc(stack)
            if (nk_widget(bounds, context) == NK_WIDGET_INVALID) return
            val canvas = nk_window_get_canvas(context) ?: return
            nk_fill_rect(canvas, bounds, 3f, UiStyle.set(NkColor.malloc(stack), color))
        }
    }

    companion object {
        const val LINE: Float = 22f

        /** What a line of a [paragraph] takes. */
        const val TEXT_LINE: Float = 21f
        private const val EDGES = 36f
        private const val FILLED = 0.94f
        private const val SLIDER_STEPS = 1000
        private const val TEXT_TOP = 2f

        /** How Nuklear tells properties without a name apart. */
        private val NUMBER = BufferUtils.createByteBuffer(1).put('#'.code.toByte()).flip()
        private const val MAX_LIST = 420f
    }
}
