package cga.coach.host

import cga.coach.Program
import cga.coach.numbers.Numbers
import cga.coach.numbers.Sources
import cga.coach.ui.say
import cga.framework.GameWindow
import cga.framework.InputError
import cga.framework.image.PngFile
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL33C.glViewport
import java.nio.file.Files
import java.nio.file.Path

/** The window that a student's program plays in, with what looks at it. */
internal class CoachWindow(private val wish: WindowWish) :
    GameWindow(wish.width, wish.height, wish.fullscreen, wish.vsync, 3, 3, wish.title, wish.samples, wish.frequency) {
    val inputs = Inputs(updateStep)
    private val numbers = Numbers()
    private val watch = GlWatch(numbers)
    private lateinit var player: Player
    private lateinit var overlay: Overlay
    private lateinit var sources: Sources
    private var origin: Origin? = null
    private var load: (Loaded) -> Program = { error("nothing to load") }
    private var first: Program? = null
    private lateinit var classes: Watch
    private lateinit var files: Watch
    private var wantsCursor = true
    private var isTurning = false
    private val look = CoachLook()

    public override fun open() {
        super.open()
        watch.start()
    }

    /** Plays [first], or else what [load] makes of the classes of [origin], until the window is closed. */
    fun play(
        origin: Origin?,
        load: (Loaded) -> Program,
        first: Program?,
    ) {
        this.origin = origin
        this.load = load
        this.first = first
        run()
    }

    override fun start() {
        player = Player(watch, inputs)
        sources = Sources(numbers) { player.guard("render") { player.program?.render(0f, inputs.time.toFloat()) } }
        overlay = Overlay(this, player, look, Panel(player, look, numbers, sources, TaskReader.NONE::read))
        classes = Watch({ origin?.watched.orEmpty() }) { it.endsWith(".class") || it.endsWith(".status") }
        files = Watch({ FILES.map(Path::of) }) { !it.startsWith(".") && !it.endsWith("~") }
        val program = first
        val code = origin?.classes?.let(::StudentCode)
        if (program != null) {
            overlay.complaint = player.replace(framebufferWidth, framebufferHeight, { code?.has(it) ?: false }) { program }
        } else {
            reload()
        }
        reportComplaint()
        overlay.start(currentTime)
    }

    override fun update(
        dt: Float,
        t: Float,
    ) {
        if (!look.isPaused) player.update()
    }

    override fun render(
        dt: Float,
        t: Float,
    ) {
        val codeChanged = classes.hasChanged()
        val filesChanged = files.hasChanged()
        val wish = look.take()
        if (wish == Wish.RESTART) inputs.forget()
        if (wish == Wish.CLOSE) openPanel(false)
        if (codeChanged || filesChanged || wish == Wish.RELOAD || wish == Wish.RESTART) reload()
        watch.isCloser = look.isOpen || numbers.isAnyChanged
        numbers.nextPicture()
        player.render(dt, framebufferWidth, framebufferHeight)
        if (look.isOpen && player.trouble == null) lookAtSources()
        if (wish == Wish.SCREENSHOT) saveScreenshot()
        overlay.draw(currentTime)
        // The compiler has more to do then.
        if (player.program == null) Thread.sleep(IDLE_MILLIS)
    }

    private fun lookAtSources() {
        if (sources.isDone) return
        sources.step()
        glViewport(0, 0, framebufferWidth, framebufferHeight)
    }

    /** Takes the program as it is on disk now; where that fails, what ran before goes on. */
    private fun reload() {
        val origin = origin ?: return
        val complaint = origin.complaint
        val folder = origin.classes
        overlay.complaint =
            when {
                complaint != null -> Trouble.ofCompiler(complaint, player.cure)
                folder == null -> null
                else -> {
                    val code = StudentCode(folder)
                    player.replace(framebufferWidth, framebufferHeight, code::has) { load(Loaded(code, origin.mainClass)) }.also {
                        if (it == null) reloaded()
                    }
                }
            }
        overlay.isWaiting = folder == null && complaint == null
        reportComplaint()
    }

    private fun reloaded() {
        numbers.forgetPrograms()
        sources.begin()
        overlay.say(say("reloaded", "neu geladen"), currentTime)
    }

    private fun reportComplaint() {
        overlay.complaint?.let { System.err.println(it.text) }
    }

    fun wantCursor(visible: Boolean) {
        wantsCursor = visible
        if (!look.isOpen) setCursorVisible(visible)
    }

    override fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ) {
        if (overlay.key(key, action)) return
        if (action == GLFW_PRESS && press(key)) return
        player.guard("onKey") { inputs.key(player.program, key, scancode, action, mode) }
    }

    /** Whether [key] is one of ours. */
    private fun press(key: Int): Boolean {
        when (key) {
            GLFW_KEY_TAB -> openPanel(!look.isOpen)
            GLFW_KEY_H, GLFW_KEY_F1 -> look.showsKeys = !look.showsKeys
            GLFW_KEY_F5 -> look.want(Wish.RESTART)
            GLFW_KEY_P -> look.isPaused = !look.isPaused
            GLFW_KEY_R -> look.want(Wish.RELOAD)
            GLFW_KEY_F12 -> look.want(Wish.SCREENSHOT)
            else -> return false
        }
        return true
    }

    private fun openPanel(open: Boolean) {
        look.isOpen = open
        isTurning = false
        setCursorVisible(open || wantsCursor)
    }

    override fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ) {
        overlay.move(xpos, ypos)
        // With the panel open the mouse is the panel's, unless the right button is held down.
        if (!look.isOpen || isTurning) player.guard("onMouseMove") { inputs.mouse(player.program, xpos, ypos) }
    }

    override fun onMouseButton(
        button: Int,
        action: Int,
        mode: Int,
    ) {
        if (look.isOpen) {
            overlay.button(button, action)
            if (button == GLFW_MOUSE_BUTTON_RIGHT) isTurning = action == GLFW_PRESS && !overlay.isMouseOver
        } else {
            player.guard("onMouseButton") { player.program?.onMouseButton(button, action, mode) }
        }
    }

    override fun onScroll(
        x: Double,
        y: Double,
    ) {
        if (look.isOpen) overlay.scroll(x, y) else player.guard("onMouseScroll") { player.program?.onMouseScroll(x, y) }
    }

    override fun onCharacter(codePoint: Int) {
        overlay.character(codePoint)
    }

    private fun saveScreenshot() {
        try {
            val names = generateSequence(1) { it + 1 }.map { Path.of("screenshot-%03d.png".format(it)) }
            val file = names.first { !Files.exists(it) }
            PngFile.write(readPicture(), file)
            overlay.say(say("saved $file", "$file gespeichert"), currentTime)
        } catch (e: InputError) {
            overlay.say(e.message.orEmpty(), currentTime)
        }
    }

    override fun shutdown() {
        classes.close()
        files.close()
        player.close()
        overlay.close()
        numbers.close()
    }

    private companion object {
        /** Folders with files that the program reads: it starts anew when one of them is saved. */
        val FILES = listOf("assets", "shaders", "src/main/resources")
        const val IDLE_MILLIS = 30L
    }
}
