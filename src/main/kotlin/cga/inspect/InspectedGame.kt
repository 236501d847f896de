package cga.inspect

import cga.exercise.game.Game
import cga.exercise.game.Step
import cga.framework.Home
import cga.framework.InputError
import cga.framework.SpecularModel
import cga.inspect.doctor.EvidenceReader
import cga.inspect.gizmo.Gizmos
import cga.inspect.probe.Probe
import cga.inspect.record.Recorder
import cga.inspect.tune.Tuning
import cga.inspect.ui.Ui
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

    private val tuning = Tuning(scene)
    private val switches = Switches()
    private val notices = Notices()
    private val panel = ControlPanel(scene, look, tuning, switches, ::copy)
    private val probePanel = ProbePanel()
    private val pointer = Pointer()
    private val dark = DarkWatch(this, look, EvidenceReader(scene, look, traffic))
    private lateinit var ui: Ui
    private lateinit var gizmos: Gizmos
    private lateinit var shaders: ShaderWatch
    private var isOpen = false
    private var isPicking = false
    private var orbitX = Double.NaN
    private val recorder = Recorder(step)

    override fun start() {
        ui = Ui(pixelRatio)
        gizmos = Gizmos(scene)
        shaders = ShaderWatch(Home.resolve("shaders"))
        // Last, since it names the step in the title: the sign that the window is ready.
        super.start()
    }

    override fun update(
        dt: Float,
        t: Float,
    ) {
        turn()
        if (switches.isPaused) return
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
            drawScene()
        } catch (e: InputError) {
            report(e)
        }
        if (isPicking) pick()
        if (switches.hasGizmos && notices.error == null) gizmos.draw()
    }

    private fun drawScene() {
        if (!look.isSplit) return scene.render()
        val divider = (look.divider * framebufferWidth).toInt()
        glEnable(GL_SCISSOR_TEST)
        glScissor(0, 0, divider, framebufferHeight)
        look.specularModel = SpecularModel.PHONG
        scene.render()
        glScissor(divider, 0, framebufferWidth - divider, framebufferHeight)
        look.specularModel = SpecularModel.BLINN_PHONG
        scene.render()
        look.specularModel = null
        glDisable(GL_SCISSOR_TEST)
    }

    override fun render(
        dt: Float,
        t: Float,
    ) {
        super.render(dt, t)
        if (notices.error == null) dark.look(currentTime)?.let { notices.findings = it }
        if (!isOpen && !look.isSplit && !notices.isAny(currentTime)) return
        val width = framebufferWidth / pixelRatio
        val height = framebufferHeight / pixelRatio
        ui.begin()
        if (look.isSplit) drawDivider(width, height)
        notices.draw(ui, width, height, if (isOpen) ControlPanel.TAKES else 0f, currentTime)
        if (isOpen) {
            probePanel.draw(ui, width, height, pixelRatio)
            panel.draw(ui, width, height)
        }
        glViewport(0, 0, framebufferWidth, framebufferHeight)
        ui.end(width.toInt(), height.toInt())
    }

    private fun drawDivider(
        width: Float,
        height: Float,
    ) = ui.canvas(width, height) {
        val x = look.divider * width
        line(x, 0f, x, height, DIVIDER)
        words("Phong", x - 62f, 8f, DIVIDER)
        words("Blinn-Phong", x + 12f, 8f, DIVIDER)
    }

    /** The pixel under the cursor, with the picture still as it was drawn. */
    private fun pick() {
        isPicking = false
        val column = (mousePos.xpos * pixelRatio).toInt().coerceIn(0, framebufferWidth - 1)
        val row = (mousePos.ypos * pixelRatio).toInt().coerceIn(0, framebufferHeight - 1)
        val side = if (column < (look.divider * framebufferWidth).toInt()) SpecularModel.PHONG else SpecularModel.BLINN_PHONG
        look.specularModel = if (look.isSplit) side else scene.specularModel
        val model = look.specularModel ?: scene.specularModel
        probePanel.show(Probe(scene).look(column, row, framebufferWidth, framebufferHeight, look, model))
        look.specularModel = null
        glViewport(0, 0, framebufferWidth, framebufferHeight)
    }

    override fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ) {
        if (isOpen) ui.input.key(key, action)
        if (isOpen && ui.isTypingIn(ControlPanel.TITLE)) return
        val step = scene.step
        if (action == GLFW_PRESS && (key in GLFW_KEY_1..GLFW_KEY_8 || key == GLFW_KEY_B)) recorder.press(key)
        super.onKey(key, scancode, action, mode)
        if (scene.step != step) {
            tuning.stepChanged()
            look.light = 0
            dark.changed()
        }
        if (action == GLFW_PRESS) press(key, mode and GLFW_MOD_SHIFT != 0)
    }

    private fun press(
        key: Int,
        isShifted: Boolean,
    ) {
        when (key) {
            GLFW_KEY_TAB -> openPanel(!isOpen)
            GLFW_KEY_V -> look.view = View.entries[Math.floorMod(look.view.ordinal + (if (isShifted) -1 else 1), View.entries.size)]
            GLFW_KEY_F -> look.isSplit = !look.isSplit
            GLFW_KEY_G -> switches.hasGizmos = !switches.hasGizmos
            GLFW_KEY_P -> switches.isPaused = !switches.isPaused
            GLFW_KEY_F9 -> saveRecording()
            GLFW_KEY_C -> copy(tuning.toKotlin())
            else -> return
        }
        if (key == GLFW_KEY_V) notices.say("${look.view.title}: ${look.view.legend}", currentTime)
    }

    private fun openPanel(open: Boolean) {
        isOpen = open
        setCursorVisible(open)
        pointer.pause()
        if (!open) probePanel.show(null)
    }

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ) {
        pointer.move(xpos, isOpen)
        if (isOpen) ui.input.move(xpos, ypos)
        if (pointer.isDividing) look.divider = (xpos * pixelRatio / framebufferWidth).toFloat()
    }

    override fun onMouseButton(
        button: Int,
        action: Int,
        mode: Int,
    ) {
        if (!isOpen) return
        ui.input.button(button, action)
        if (action == GLFW_RELEASE) return pointer.release(button)
        if (ui.isOver(mousePos.xpos.toFloat(), mousePos.ypos.toFloat())) return
        val isOnDivider = look.isSplit && abs(mousePos.xpos * pixelRatio - look.divider * framebufferWidth) < GRIP * pixelRatio
        if (pointer.press(button, isOnDivider)) isPicking = true
    }

    override fun onScroll(
        x: Double,
        y: Double,
    ) {
        if (isOpen) ui.input.scroll(x, y)
    }

    override fun onCharacter(codePoint: Int) {
        if (isOpen) ui.input.character(codePoint)
    }

    override fun reloadShaders() {
        try {
            traffic.warnings.clear()
            scene.reloadShaders()
            notices.error = null
            notices.say("shaders reloaded", currentTime)
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
        notices.say("screenshot saved", currentTime)
    }

    private fun saveRecording() {
        try {
            if (recorder.isFull) throw InputError("the recording is full: start the window anew for another.")
            val file = freeName("recording-%03d.txt")
            recorder.recording().write(file)
            println("saved $file")
            notices.say("saved $file: ./cga replay $file", currentTime)
        } catch (e: InputError) {
            System.err.println(e.message)
        }
    }

    private fun copy(code: String) {
        copyToClipboard(code)
        notices.say("copied as Kotlin code", currentTime)
    }

    override fun shutdown() {
        shaders.close()
        dark.close()
        gizmos.close()
        ui.close()
        super.shutdown()
    }

    public companion object {
        /** The keys, for people. */
        public const val HELP: String =
            "${Game.HELP} · Tab panel and cursor (click a pixel for its numbers, right button orbits) · V what is shown · " +
                "F Phong beside Blinn-Phong · G light gizmos · P pause time · C copy values as Kotlin · F9 save all input since the start"
        private const val DIVIDER = 0xFFFFFFD0
        private const val GRIP = 8.0
    }
}
