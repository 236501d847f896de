package cga.coach.host

import cga.coach.Program
import org.lwjgl.glfw.GLFW.GLFW_KEY_LAST
import org.lwjgl.glfw.GLFW.GLFW_RELEASE

/**
 * All that a program was told since the start: keys, mouse, and the time. Another one that is told the same is where the first one was, so
 * time, drive and camera go on when classes are replaced, whatever they are called.
 *
 * @param step length of an update in seconds.
 */
internal class Inputs(private val step: Double) {
    private val events = ArrayList<Event>()
    private val held = BooleanArray(GLFW_KEY_LAST + 1)
    private var updates = 0L

    /** Time of the last update, in seconds. */
    val time: Double get() = updates * step
    var mouseX: Double = 0.0
        private set
    var mouseY: Double = 0.0
        private set

    fun isDown(key: Int): Boolean = key in held.indices && held[key]

    /** Tells [program] of a key, and remembers it. */
    fun key(
        program: Program?,
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ) {
        val event = KeyEvent(updates, key, scancode, action, mode)
        events += event
        tell(program, event)
    }

    /** Tells [program] where the mouse is, and remembers it. */
    fun mouse(
        program: Program?,
        x: Double,
        y: Double,
    ) {
        val event = MouseEvent(updates, x, y)
        // Between two updates only the last place counts.
        if ((events.lastOrNull() as? MouseEvent)?.at == updates) events.removeLast()
        events += event
        tell(program, event)
    }

    /** Tells [program] that the time has come for an update. */
    fun update(program: Program?) {
        updates++
        program?.update(step.toFloat(), time.toFloat())
    }

    /** Tells [program] everything once more. Answers false where that takes too long, and [program] has seen only the beginning. */
    fun replay(program: Program): Boolean {
        val (end, endX, endY) = Triple(updates, mouseX, mouseY)
        val start = System.nanoTime()
        held.fill(false)
        updates = 0
        var next = 0
        while (true) {
            while (next < events.size && events[next].at == updates) tell(program, events[next++])
            if (updates == end) break
            if (updates % CHECKED == 0L && System.nanoTime() - start > PATIENCE) break
            update(program)
        }
        val isWhole = updates == end
        updates = end
        mouseX = endX
        mouseY = endY
        while (next < events.size) (events[next++] as? KeyEvent)?.let(::hold)
        return isWhole
    }

    /** Forgets everything: the time is 0 again. Keys that are held down stay so. */
    fun forget() {
        events.clear()
        updates = 0
    }

    private fun tell(
        program: Program?,
        event: Event,
    ) {
        when (event) {
            is KeyEvent -> {
                hold(event)
                program?.onKey(event.key, event.scancode, event.action, event.mode)
            }
            is MouseEvent -> {
                mouseX = event.x
                mouseY = event.y
                program?.onMouseMove(event.x, event.y)
            }
        }
    }

    private fun hold(event: KeyEvent) {
        if (event.key in held.indices) held[event.key] = event.action != GLFW_RELEASE
    }

    /** Something that happened after so many updates. */
    private sealed class Event(val at: Long)

    private class KeyEvent(
        at: Long,
        val key: Int,
        val scancode: Int,
        val action: Int,
        val mode: Int,
    ) : Event(at)

    private class MouseEvent(
        at: Long,
        val x: Double,
        val y: Double,
    ) : Event(at)

    private companion object {
        /** So often the clock is looked at. */
        const val CHECKED = 256L

        /** Nanoseconds that a window may stand still. */
        const val PATIENCE = 1_000_000_000L
    }
}
