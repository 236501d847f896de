package cga.coach.host

import cga.coach.Host
import cga.coach.Program
import cga.coach.Stage
import cga.coach.ui.say
import cga.framework.InputError
import java.nio.file.Path
import kotlin.system.exitProcess

/** The one window of a process. It is found by its name. */
public class CoachHost : Host {
    private var opened: CoachWindow? = null
    private val open: CoachWindow get() = checkNotNull(opened) { "the window is not open" }

    /** The program that a `main` of theirs wants played while another one plays. */
    private var incoming: Program? = null
    private var isLoading = false

    override val window: Long get() = open.handle
    override val framebufferWidth: Int get() = open.framebufferWidth
    override val framebufferHeight: Int get() = open.framebufferHeight
    override val time: Double get() = open.inputs.time
    override val mouseX: Double get() = open.inputs.mouseX
    override val mouseY: Double get() = open.inputs.mouseY

    override fun open(stage: Stage) {
        open(WindowWish.of(stage))
        open.setTitle(stage.title)
    }

    private fun open(wish: WindowWish) {
        if (opened == null) orElse { opened = CoachWindow(wish).apply { open() } }
    }

    override fun run(program: Program) {
        if (isLoading) {
            incoming = program
            return
        }
        val origin = Compiled.of(program.javaClass)
        orElse { open.play(origin, { load(it) }, program) }
    }

    override fun runBuilt() {
        val status = Path.of(System.getProperty("cga.status"))
        open(WindowWish.COURSE)
        orElse { open.play(Built(System.getProperty("cga.main"), status), { load(it) }, null) }
    }

    /** The program that the classes of [origin] make. */
    private fun load(origin: Loaded): Program {
        isLoading = true
        incoming = null
        try {
            origin.code.start(origin.mainClass)
        } finally {
            isLoading = false
        }
        return incoming ?: error(say("main() ends without starting a game", "main() endet, ohne ein Spiel zu starten"))
    }

    /** A machine without a display, or without OpenGL, is no mistake in the program. */
    private fun orElse(action: () -> Unit) {
        try {
            action()
        } catch (e: InputError) {
            System.err.println(e.message)
            exitProcess(2)
        }
    }

    override fun isDown(key: Int): Boolean = open.inputs.isDown(key)

    override fun setCursorVisible(visible: Boolean) {
        open.wantCursor(visible)
    }

    override fun setTitle(text: String): Unit = open.setTitle(text)

    override fun quit(): Unit = open.quit()
}

/** Classes to be started. */
internal class Loaded(
    val code: StudentCode,
    val mainClass: String,
)

/** What a program wants its window to be. */
internal class WindowWish(
    val width: Int,
    val height: Int,
    val fullscreen: Boolean,
    val vsync: Boolean,
    val title: String,
    val samples: Int,
    val frequency: Int,
) {
    companion object {
        /** The window of the course. */
        val COURSE = WindowWish(1280, 720, fullscreen = false, vsync = true, "CGA", 4, 120)

        fun of(stage: Stage) =
            WindowWish(stage.width, stage.height, stage.fullscreen, stage.vsync, stage.title, stage.samples, stage.updateFrequency.toInt())
    }
}
