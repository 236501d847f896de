package cga.coach.numbers

import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.FloatImage
import org.lwjgl.opengl.GL33C.*
import kotlin.math.abs

/**
 * Finds the colours that the picture is a sum of: a light's, or that of the emission. They are told from all other numbers by what the
 * program draws: half of such a colour changes the picture by half of what none of it changes. One is looked at in each picture. Needs the context.
 *
 * @param draw has the program draw its picture into the framebuffer that is bound.
 */
internal class Sources(
    private val numbers: Numbers,
    private val draw: () -> Unit,
) {
    private val found = LinkedHashSet<Sent>()
    private var waiting: List<Sent>? = null
    private var whole: FloatImage? = null

    /** Those found so far. */
    val all: Set<Sent> get() = found

    /** Whether all have been looked at. */
    val isDone: Boolean get() = waiting?.isEmpty() ?: false

    /** Looks anew, since the program is another one. */
    fun begin() {
        found.clear()
        waiting = null
        whole = null
    }

    /** Looks at the next number. */
    fun step() {
        val before = waiting
        if (before == null) {
            waiting = numbers.all.filter { it.size == COLOR && !it.isChanged }
            whole = picture()
            return
        }
        val next = before.firstOrNull() ?: return
        waiting = before.drop(1)
        if (!next.isChanged && isSource(next)) found += next
    }

    /** Sends only [source] of all that were found, or all again where it is alone already. */
    fun solo(source: Sent) {
        val isAlone = found.all { it === source || it.scale == 0f }
        for (other in found) other.scale = if (isAlone || other === source) 1f else 0f
    }

    private fun isSource(sent: Sent): Boolean {
        val all = whole ?: return false
        val none = picture(sent, 0f)
        val half = picture(sent, 0.5f)
        var change = 0f
        var bend = 0f
        for (i in all.rgba.indices) {
            change = maxOf(change, abs(all.rgba[i] - none.rgba[i]))
            bend = maxOf(bend, abs(half.rgba[i] - (all.rgba[i] + none.rgba[i]) / 2))
        }
        return change > VISIBLE && bend < change * STRAIGHT
    }

    private fun picture(
        sent: Sent,
        scale: Float,
    ): FloatImage {
        sent.scale = scale
        try {
            return picture()
        } finally {
            sent.scale = 1f
        }
    }

    private fun picture(): FloatImage =
        RenderTarget(WIDTH, HEIGHT, 0, ColorFormat.RGBA32F)
            .use { target ->
                target.bind()
                draw()
                target.readFloats()
            }.also { glBindFramebuffer(GL_FRAMEBUFFER, 0) }

    private companion object {
        const val COLOR = 3
        const val WIDTH = 96
        const val HEIGHT = 54

        /** One step of 255. */
        const val VISIBLE = 1f / 255

        /** Sums of floats are off by some 1e-7 of the largest; a colour that is not a factor bends by much more. */
        const val STRAIGHT = 1e-3f
    }
}
