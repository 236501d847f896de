package cga.exercise.game

import cga.exercise.components.shader.ShaderProgram
import cga.framework.GameWindow
import cga.framework.InputError
import cga.framework.image.PngFile
import org.lwjgl.glfw.GLFW.*
import java.nio.file.Files
import java.nio.file.Path

/** The scene in a window: W/A/S/D drive, the mouse orbits, 1–8 choose the step, B, R, F12 and Esc as [HELP] says. */
public open class Game(
    width: Int,
    height: Int,
    fullscreen: Boolean,
    msaasamples: Int,
    step: Step,
    newProgram: NewProgram,
) : GameWindow(width, height, fullscreen, true, 3, 3, "CGA Lights", msaasamples, 120) {
    public constructor(
        width: Int = 1280,
        height: Int = 720,
        fullscreen: Boolean = false,
        msaasamples: Int = 4,
        step: Step = Step.FINAL,
    ) : this(width, height, fullscreen, msaasamples, step, ::ShaderProgram)

    protected val scene: Scene = Scene(this, step, newProgram)
    private var screenshotWanted = false

    override fun start() {
        setCursorVisible(false)
        nameStep()
    }

    override fun update(
        dt: Float,
        t: Float,
    ) {
        // The same numbers as dt and t, in double precision.
        scene.update(updateStep, currentTime)
    }

    override fun render(
        dt: Float,
        t: Float,
    ) {
        draw()
        if (screenshotWanted) saveScreenshot()
    }

    /** Draws the picture that F12 saves. */
    protected open fun draw() {
        scene.render()
    }

    override fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ) {
        scene.onKey(key, scancode, action, mode)
        if (action != GLFW_PRESS) return
        when (key) {
            GLFW_KEY_R -> reloadShaders()
            GLFW_KEY_F12 -> screenshotWanted = true
            GLFW_KEY_ESCAPE -> quit()
        }
        nameStep()
    }

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ) {
        scene.onMouseMove(xpos, ypos)
    }

    override fun shutdown() {
        scene.cleanup()
    }

    /** Tells in the window's title what is shown. */
    protected fun nameStep() {
        setTitle("CGA Lights · ${scene.step.sheet} ${scene.step.title} · ${scene.specularModel.title}")
    }

    // An error in a student's shader is no reason to end the program: the old one goes on.
    protected open fun reloadShaders() {
        try {
            scene.reloadShaders()
            println("shaders reloaded")
        } catch (e: InputError) {
            System.err.println("${e.message}\nThe old shaders stay in use.")
        }
    }

    /** Saves what was drawn under the next free name. */
    protected open fun saveScreenshot() {
        screenshotWanted = false
        try {
            val file = freeName("screenshot-%03d.png")
            PngFile.write(readPicture(), file)
            println("saved $file")
        } catch (e: InputError) {
            System.err.println(e.message)
        }
    }

    /** The first of [pattern] with 1, 2, … that no file has yet. */
    protected fun freeName(pattern: String): Path {
        val names = generateSequence(1) { it + 1 }.map { Path.of(pattern.format(it)) }
        return names.first { !Files.exists(it) }
    }

    public companion object {
        /** The keys, for people. */
        public const val HELP: String =
            "W/A/S/D drive and steer · mouse orbits · 1–8 steps of the sheet · B Phong/Blinn-Phong · " +
                "R reload shaders · F12 screenshot · Esc quit"
    }
}
