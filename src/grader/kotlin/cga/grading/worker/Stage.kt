package cga.grading.worker

import cga.coach.calls.Call
import cga.coach.calls.Interception
import cga.grading.capture.CaptureLimits
import cga.grading.capture.Cursor
import cga.grading.capture.EventKind
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL
import org.lwjgl.opengl.GL33C.glViewport
import org.lwjgl.system.MemoryStack

/**
 * What the stand-in for the course's GameWindow stands on: an off-screen window, and a script in the place of clock, keyboard and mouse.
 *
 * The stand-in is compiled with the submission, perhaps by an old compiler: everything here is plain numbers. It asks [next] what to do,
 * reads the numbers that belong to it, does it, and asks again.
 *
 * @param samples a pixel that the window is asked for.
 * @param frequency updates a second.
 */
public class Stage(
    private val width: Int,
    private val height: Int,
    title: String,
    major: Int,
    minor: Int,
    samples: Int,
    private val frequency: Double,
) {
    private val tape = Session.claim()
    private val recorder: Recorder
    private val interception: Interception
    private val acts: Iterator<Act>
    private val held = HashSet<Int>()
    private val asked = HashSet<Int>()
    private var isRendering = false
    private var updates = 0L
    private var lastPicture = 0L
    private var isEnded = false

    /** GLFW's handle of the window. */
    public val window: Long
    private val callbacks: OwnCallbacks

    /** Seconds of one update, or between two pictures. */
    public var dt: Float = 0f
        private set

    /** Seconds since the start: updates times their length. */
    public val time: Double get() = updates / frequency

    /** GLFW's key of a key event; [action] and [modifiers] belong to it. */
    public var key: Int = 0
        private set
    public var action: Int = 0
        private set
    public var modifiers: Int = 0
        private set

    /** The cursor in screen coordinates, likewise [cursorY]: where the script moved it, or the program put it since. */
    public val cursorX: Double get() = cursor().x
    public val cursorY: Double get() = cursor().y

    /** Where the script has the cursor, whatever the program did with it. */
    private var scripted = Play.start

    init {
        require(width in 1..CaptureLimits.SIDE && height in 1..CaptureLimits.SIDE) { "a window of ${width}x$height cannot be opened" }
        require(frequency in 1.0..MAX_FREQUENCY) { "$frequency updates a second cannot be played" }
        val offscreen = OffscreenWindow(width, height, title, major, minor)
        window = offscreen.handle
        callbacks = OwnCallbacks(window)
        // The recorder needs OpenGL before it can look at calls: the very first go by unseen.
        var observer: (Call) -> Unit = Call::proceed
        interception = Interception({ glfwGetProcAddress(it) }) { observer(it) }
        GL.create(interception)
        recorder =
            interception.aside {
                GL.createCapabilities(true)
                val framebuffer = WindowFramebuffer(width, height, samples)
                glViewport(0, 0, width, height)
                tape.window(width, height, framebuffer.samples)
                Recorder(tape, framebuffer)
            }
        observer = recorder::observe
        if (offscreen.version != "$major.$minor") tape.event(EventKind.NOT_CAPTURED, "OpenGL $major.$minor: ${offscreen.version} is given")
        acts = Play.acts(frequency, asked)
        ScriptedCalls.time = { time }
        ScriptedCalls.isHeld = ::isHeld
        glfwSetCursorPos(window, scripted.x, scripted.y)
    }

    /** What to do next, one of the constants of this class; ends what was done before. */
    public fun next(): Int {
        finishPicture(true)
        while (!isEnded && acts.hasNext()) {
            when (val act = acts.next()) {
                is Act.Update -> return update(act)
                is Act.Press -> press(act).let { if (!callbacks.key(act)) return it }
                is Act.Move -> move(act).let { if (!callbacks.move(cursor())) return it }
                is Act.Render -> return render(act)
            }
        }
        return END
    }

    /** Whether [key] is held down. */
    public fun isHeld(key: Int): Boolean {
        asked += key
        return key in held
    }

    /** No more after what is being done now. */
    public fun quit() {
        isEnded = true
    }

    /** The game threw [problem]: nothing more will be asked. */
    public fun fail(problem: Throwable) {
        finishPicture(false)
        Session.fail(problem)
        isEnded = true
    }

    private fun update(act: Act.Update): Int {
        updates = act.number
        dt = (1 / frequency).toFloat()
        return UPDATE
    }

    private fun press(act: Act.Press): Int {
        key = act.key
        modifiers = act.modifiers
        action = if (act.isDown) GLFW_PRESS else GLFW_RELEASE
        if (act.isDown) held += act.key else held -= act.key
        return KEY
    }

    /** A mouse is moved by a way, and the cursor goes it from wherever it is. */
    private fun move(act: Act.Move): Int {
        val from = cursor()
        glfwSetCursorPos(window, from.x + act.cursor.x - scripted.x, from.y + act.cursor.y - scripted.y)
        scripted = act.cursor
        return MOVE
    }

    private fun cursor(): Cursor =
        MemoryStack.stackPush().use { stack ->
            val x = stack.mallocDouble(1)
            val y = stack.mallocDouble(1)
            glfwGetCursorPos(window, x, y)
            Cursor(x[0], y[0])
        }

    private fun render(act: Act.Render): Int {
        dt = ((updates - lastPicture) / frequency).toFloat()
        lastPicture = updates
        tape.frame++
        isRendering = true
        interception.aside { recorder.begin(act.moment) }
        return RENDER
    }

    private fun finishPicture(isWhole: Boolean) {
        if (!isRendering) return
        isRendering = false
        interception.aside { recorder.end(time, isWhole) }
    }

    public companion object {
        /** The script is at its end. */
        public const val END: Int = 0

        /** Update the game: [dt], [time]. */
        public const val UPDATE: Int = 1

        /** Draw a picture: [dt], [time]. */
        public const val RENDER: Int = 2

        /** A key event: [key], [action], [modifiers]. */
        public const val KEY: Int = 3

        /** The cursor has moved: [cursorX], [cursorY]. */
        public const val MOVE: Int = 4

        private const val MAX_FREQUENCY = 10_000.0
    }
}
