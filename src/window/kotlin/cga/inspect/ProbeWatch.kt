package cga.inspect

import cga.exercise.game.Scene
import cga.framework.GameWindow
import cga.framework.SpecularModel
import cga.inspect.probe.Probe
import cga.inspect.probe.Probed
import cga.inspect.view.Look
import org.lwjgl.opengl.GL33C.glViewport
import java.util.concurrent.Future

/** Keeps the numbers of the pixel that was clicked up to date, whatever becomes of step, view and time. Needs the context. */
internal class ProbeWatch(
    private val window: GameWindow,
    private val scene: Scene,
    private val look: Look,
    private val modelAt: (column: Int) -> SpecularModel,
) : AutoCloseable {
    private val probe = Probe(scene)
    private var column = NOWHERE
    private var row = NOWHERE
    private var next = 0.0
    private var pending: Future<Probed>? = null

    /** Looks at the pixel under the cursor from now on. */
    fun pick() {
        column = (window.mousePos.xpos * window.pixelRatio).toInt().coerceIn(0, window.framebufferWidth - 1)
        row = (window.mousePos.ypos * window.pixelRatio).toInt().coerceIn(0, window.framebufferHeight - 1)
        next = 0.0
    }

    /** Looks at nothing any more. */
    fun stop() {
        column = NOWHERE
        pending = null
    }

    /** After a picture was drawn, at [time] (seconds): the newest numbers, or null where there are no new ones. */
    fun look(time: Double): Probed? {
        if (column == NOWHERE || column >= window.framebufferWidth || row >= window.framebufferHeight) return null
        val done = pending?.takeIf { it.isDone }?.get()
        if (done != null) pending = null
        if (pending == null && time >= next) begin(time)
        return done
    }

    private fun begin(time: Double) {
        next = time + PAUSE
        val model = modelAt(column)
        look.specularModel = model
        pending = probe.look(column, row, window.framebufferWidth, window.framebufferHeight, look, model)
        look.specularModel = null
        glViewport(0, 0, window.framebufferWidth, window.framebufferHeight)
    }

    override fun close() {
        probe.close()
    }

    private companion object {
        const val NOWHERE = -1

        /** Seconds from one look to the next. */
        const val PAUSE = 0.4
    }
}
