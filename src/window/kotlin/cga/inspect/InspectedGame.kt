package cga.inspect

import cga.coach.host.Watch
import cga.coach.ui.say
import cga.exercise.game.Game
import cga.exercise.game.Step
import cga.framework.Home
import cga.framework.InputError
import cga.inspect.doctor.EvidenceReader
import cga.inspect.record.Recorder
import cga.inspect.tune.Tuning
import cga.inspect.view.InspectedProgram
import cga.inspect.view.Look
import cga.inspect.view.Traffic
import cga.inspect.view.View
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL33C.*
import kotlin.math.abs

/**
 * The scene's window with a look into it: terms and factors alone, a probe, a panel of all numbers, gizmos, errors and likely causes of a
 * dark picture on the screen, shaders that reload when they are saved. Keys as [HELP] says.
 */
public open class InspectedGame private constructor(
    width: Int,
    height: Int,
    fullscreen: Boolean,
    msaasamples: Int,
    step: Step,
    private val look: Look,
    private val traffic: Traffic,
) : Game(width, height, fullscreen, msaasamples, step, { v, f, constants -> InspectedProgram(v, f, constants, look, traffic) }) {
    public constructor(width: Int, height: Int, fullscreen: Boolean, msaasamples: Int, step: Step) :
        this(width, height, fullscreen, msaasamples, step, Look(), Traffic())

    private val recorder = Recorder(step, look)
    private val tuning = Tuning(scene, recorder::turn, recorder::reset)
    private val inspected = InspectedScene(scene, look, tuning)
    private val clock = Clock()
    private val notices = Notices()
    private val pointer = Pointer()
    private val dark = DarkWatch(this, look, EvidenceReader(scene, look, traffic))
    private lateinit var overlay: Overlay
    private lateinit var shaders: Watch
    private val probe = ProbeWatch(this, scene, look) { inspected.modelAt(it, framebufferWidth) }
    private var isPicking = false
    private var orbitX = Double.NaN

    override fun start() {
        overlay = Overlay(this, look, notices, ControlPanel(scene, look, tuning, clock, actions()), inspected)
        shaders = Watch({ listOf(Home.resolve("shaders")) }) { it.substringAfterLast('.') in SHADERS }
        notices.say(say("Tab opens the panel · H shows all keys", "Tab öffnet die Tafel · H zeigt alle Tasten"), currentTime, START_SECONDS)
        // Last, since it names the step in the title: the sign that the window is ready.
        super.start()
    }

    override fun update(
        dt: Float,
        t: Float,
    ) {
        turn()
        if (clock.isPaused) return
        recorder.update(this)
        scene.update(updateStep, recorder.updates * updateStep)
    }

    // Once an update, not once an event: so much is recorded, and replayed with the same rounding.
    private fun turn() {
        if (pointer.orbitX == orbitX) return
        orbitX = pointer.orbitX
        recorder.mouse(orbitX)
        scene.onMouseMove(orbitX, 0.0)
    }

    override fun draw() {
        if (shaders.hasChanged()) reloadShaders()
        try {
            inspected.draw(framebufferWidth, framebufferHeight)
        } catch (e: InputError) {
            report(e)
        }
        if (isPicking) probe.pick()
        isPicking = false
        if (overlay.isOpen) probe.look(currentTime)?.let { overlay.probe.show(it) }
        if (notices.error == null) inspected.drawGizmos()
    }

    override fun render(
        dt: Float,
        t: Float,
    ) {
        super.render(dt, t)
        if (notices.error == null) dark.look(currentTime)?.let { notices.findings = it }
        glViewport(0, 0, framebufferWidth, framebufferHeight)
        overlay.draw(currentTime)
    }

    override fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ) {
        overlay.input?.key(key, action)
        if (overlay.isTyping) return
        val step = scene.step
        if (action == GLFW_PRESS && (key in GLFW_KEY_1..GLFW_KEY_8 || key == GLFW_KEY_B)) recorder.press(key)
        super.onKey(key, scancode, action, mode)
        if (scene.step != step) {
            inspected.stepChanged()
            dark.changed()
        }
        if (action == GLFW_PRESS) press(key, mode and GLFW_MOD_SHIFT != 0)
    }

    /** What the panel's buttons do: all that keys do. */
    private fun actions() =
        Actions(
            press = { key -> onKey(key, 0, GLFW_PRESS, 0) },
            copy = ::copy,
            split = ::split,
        )

    private fun press(
        key: Int,
        isShifted: Boolean,
    ) {
        when (key) {
            GLFW_KEY_TAB -> openPanel(!overlay.isOpen)
            GLFW_KEY_V -> nextView(if (isShifted) -1 else 1)
            GLFW_KEY_F -> split(!look.isSplit)
            GLFW_KEY_H, GLFW_KEY_F1 -> overlay.showsKeys = !overlay.showsKeys
            GLFW_KEY_G -> look.hasGizmos = !look.hasGizmos
            GLFW_KEY_P -> clock.isPaused = !clock.isPaused
            GLFW_KEY_F9 -> saveRecording()
            GLFW_KEY_C -> copy(tuning.toKotlin())
        }
    }

    private fun nextView(by: Int) {
        look.view = View.entries[Math.floorMod(look.view.ordinal + by, View.entries.size)]
        notices.say("${look.view.title}: ${look.view.legend}", currentTime)
    }

    private fun split(isSplit: Boolean) {
        look.isSplit = isSplit
        if (!isSplit) return
        val text =
            if (inspected.areSidesEqual()) {
                say("both sides are equal here: no highlight is in sight", "beide Seiten sind hier gleich: Kein Glanzlicht ist zu sehen")
            } else {
                say("hold the left mouse button to move the divider", "die linke Maustaste halten, um die Trennlinie zu bewegen")
            }
        notices.say(text, currentTime)
        glViewport(0, 0, framebufferWidth, framebufferHeight)
    }

    private fun openPanel(open: Boolean) {
        overlay.isOpen = open
        probe.stop()
        setCursorVisible(open)
        pointer.pause()
    }

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ) {
        pointer.move(xpos, overlay.isOpen)
        overlay.move(xpos, ypos)
        if (!pointer.isDividing) return
        // A cursor that is seen has the divider under it; one that is not moves it along.
        val share = pixelRatio / framebufferWidth
        look.divider = if (overlay.isOpen) (xpos * share).toFloat() else look.divider + (pointer.movement * share).toFloat()
    }

    override fun onMouseButton(
        button: Int,
        action: Int,
        mode: Int,
    ) {
        overlay.input?.button(button, action)
        if (action == GLFW_RELEASE) return pointer.release(button)
        if (overlay.isMouseOver) return
        if (pointer.press(button, takesDivider()) && overlay.isOpen) isPicking = true
    }

    private fun takesDivider(): Boolean {
        val distance = abs(mousePos.xpos * pixelRatio - look.divider * framebufferWidth)
        return look.isSplit && (!overlay.isOpen || distance < GRIP * pixelRatio)
    }

    override fun onScroll(
        x: Double,
        y: Double,
    ) {
        overlay.input?.scroll(x, y)
    }

    override fun onCharacter(codePoint: Int) {
        overlay.input?.character(codePoint)
    }

    override fun reloadShaders() {
        try {
            traffic.warnings.clear()
            scene.reloadShaders()
            notices.error = null
            notices.say(say("shaders reloaded", "Shader neu geladen"), currentTime)
            println("shaders reloaded")
        } catch (e: InputError) {
            report(e)
        }
        dark.changed()
    }

    private fun report(error: InputError) {
        if (notices.error != error.message) System.err.println("${error.message}\nThe old shaders stay in use.")
        notices.error = error.message
    }

    override fun saveScreenshot() {
        recorder.picture()
        super.saveScreenshot()
        notices.say(say("picture saved", "Bild gespeichert"), currentTime)
    }

    private fun saveRecording() {
        try {
            if (recorder.isFull) throw InputError("the recording is full: start the window anew for another.")
            val file = freeName("recording-%03d.txt")
            recorder.recording().write(file)
            println("saved $file")
            notices.say(say("saved $file: ./cga replay $file", "$file gespeichert: ./cga replay $file"), currentTime)
        } catch (e: InputError) {
            System.err.println(e.message)
        }
    }

    private fun copy(code: String) {
        copyToClipboard(code)
        notices.say(say("copied as Kotlin code", "als Kotlin-Code kopiert"), currentTime)
    }

    override fun shutdown() {
        shaders.close()
        dark.close()
        probe.close()
        inspected.close()
        overlay.close()
        super.shutdown()
    }

    public companion object {
        /** The keys, for people. */
        public const val HELP: String =
            "${Game.HELP} · Tab panel and cursor (click a pixel for its numbers, right button orbits) · V what is shown · " +
                "H all keys · F Phong beside Blinn-Phong (hold the left button to move the divider) · G light gizmos · P pause time · " +
                "C copy values as Kotlin · F9 save all input since the start"
        private val SHADERS = setOf("vert", "frag", "glsl")
        private const val GRIP = 8.0
        private const val START_SECONDS = 6.0
    }
}
