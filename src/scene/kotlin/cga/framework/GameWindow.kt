package cga.framework

import cga.framework.context.Glfw
import cga.framework.image.ImageData
import org.lwjgl.glfw.Callbacks.glfwFreeCallbacks
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil.NULL

/**
 * A window with a game loop: [update] at a fixed rate, [render] once a picture. Derive from it and call [run].
 *
 * The window opens in [run], so a game can be constructed where there is no display.
 *
 * @param width of the window in screen coordinates, likewise [height]; the picture's pixels are [framebufferWidth] × [framebufferHeight].
 * @param fullscreen whether the window takes the whole primary monitor.
 * @param vsync whether pictures wait for the monitor.
 * @param cvmaj major version of OpenGL, with [cvmin] the minor one; core profile.
 * @param msaasamples samples a pixel, 0 for none.
 * @param updatefrequency updates a second.
 */
public abstract class GameWindow(
    public val width: Int,
    public val height: Int,
    public val fullscreen: Boolean,
    public val vsync: Boolean,
    public val cvmaj: Int,
    public val cvmin: Int,
    public val title: String,
    public val msaasamples: Int,
    updatefrequency: Int,
) : WindowState {
    /** Length of one update in seconds. */
    protected val updateStep: Double = 1.0 / updatefrequency
    private var window = NULL
    private var updates = 0L
    private val mouse = MousePosition(0.0, 0.0)
    private var cursor: WindowCursor? = null

    final override var framebufferWidth: Int = width
        private set
    final override var framebufferHeight: Int = height
        private set

    /** Framebuffer pixels per screen coordinate: 2 on many displays of high resolution. */
    public var pixelRatio: Float = 1f
        private set

    /** Framebuffer pixels for what should be a pixel's size to read by: the monitor's scale, whether or not the window system applies it. */
    public var contentScale: Float = 1f
        private set

    /** Time of the last update in seconds since [run] began: the number of updates times their length, so it never drifts. */
    public val currentTime: Double get() = updates * updateStep

    /** Called once, with the context current, before the first update. */
    protected open fun start() {}

    /**
     * Advances the game by [dt] seconds to time [t] (seconds). Floats as in the course: a Float holds t to 1 ms up to 2.3 hours and to
     * 1 s at 10⁷ s; [currentTime] is the same number in double precision.
     */
    protected open fun update(
        dt: Float,
        t: Float,
    ) {}

    /** Draws the picture of time [t]; [dt] is the time since the last picture. Both in seconds. */
    protected open fun render(
        dt: Float,
        t: Float,
    ) {}

    /** A key went down, up or repeats; GLFW's key, scancode, action and modifier constants. */
    protected open fun onKey(
        key: Int,
        scancode: Int,
        action: Int,
        mode: Int,
    ) {}

    /** The cursor moved to ([xpos], [ypos]), screen coordinates from the top left. */
    protected open fun onMouseMove(
        xpos: Double,
        ypos: Double,
    ) {}

    /** A button of the mouse went down or up; GLFW's button, action and modifier constants. */
    protected open fun onMouseButton(
        button: Int,
        action: Int,
        mode: Int,
    ) {}

    /** The wheel turned by ([x], [y]) notches, up and left positive. */
    protected open fun onScroll(
        x: Double,
        y: Double,
    ) {}

    /** A character was typed, as a Unicode code point. */
    protected open fun onCharacter(codePoint: Int) {}

    /** Called once, with the context still current, before the window closes. */
    protected open fun shutdown() {}

    override fun getKeyState(key: Int): Boolean = window != NULL && glfwGetKey(window, key) == GLFW_PRESS

    /** GLFW's handle of the open window, 0 before and after. */
    public val handle: Long get() = window

    /** The cursor's last position; the same object every time. */
    public val mousePos: MousePosition get() = mouse

    /** Shows the cursor, or hides it and lets it move without end. */
    public fun setCursorVisible(visible: Boolean) {
        cursor?.isVisible = visible
    }

    /** Puts [text] where other programs paste from. */
    public fun copyToClipboard(text: String) {
        if (window != NULL) glfwSetClipboardString(window, text)
    }

    /** Ends [run] after the current picture. */
    public fun quit() {
        if (window != NULL) glfwSetWindowShouldClose(window, true)
    }

    /** The window's title. */
    public fun setTitle(text: String) {
        if (window != NULL) glfwSetWindowTitle(window, text)
    }

    /**
     * The picture drawn so far, as the window will show it. Call it at the end of [render].
     *
     * Averages the samples by a blit: reading a multisampled window directly gives one sample a pixel on Mesa 22.3.
     */
    public fun readPicture(): ImageData =
        RenderTarget(framebufferWidth, framebufferHeight).use { picture ->
            glBindFramebuffer(GL_READ_FRAMEBUFFER, 0)
            glBlitFramebuffer(0, 0, picture.width, picture.height, 0, 0, picture.width, picture.height, GL_COLOR_BUFFER_BIT, GL_NEAREST)
            GLError.check("reading the window's picture")
            picture.read()
        }

    /** Opens the window, plays until [quit] or the close button, closes the window. Throws [InputError] without a display. */
    public fun run() {
        open()
        try {
            // GLFW takes the number of samples as a wish and says nothing when the driver has fewer.
            RenderTarget.checkSamples(msaasamples)
            start()
            try {
                loop()
            } finally {
                shutdown()
            }
        } finally {
            close()
        }
    }

    /** Opens the window and makes its context current, unless that has been done; [run] does it otherwise. Throws [InputError]. */
    protected open fun open() {
        if (window != NULL) return
        // Before the window is made: GLFW draws into it at once, and X11 ends the program when it is beyond what the driver can.
        if (maxOf(width, height) > MAX_SIDE) throw InputError("size ${width}x$height is too large for a window: at most $MAX_SIDE a side.")
        Glfw.start(GLFW_ANY_PLATFORM)?.let {
            throw InputError("no window can be opened here ($it): start it in a desktop session, or use render.")
        }
        Glfw.hintCoreProfile(cvmaj, cvmin)
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE)
        glfwWindowHint(GLFW_SAMPLES, msaasamples)
        window =
            Glfw.openWindow(
                width * INJECTED_RATIO,
                height * INJECTED_RATIO,
                title,
                if (fullscreen) glfwGetPrimaryMonitor() else NULL,
            ) { reason ->
                InputError("no window with OpenGL $cvmaj.$cvmin can be opened ($reason): install or update the graphics driver.")
            }
        glfwSwapInterval(if (vsync) 1 else 0)
        listen()
    }

    private fun listen() {
        glfwSetKeyCallback(window) { _, key, scancode, action, mode -> onKey(key, scancode, action, mode) }
        cursor = WindowCursor(window, INJECTED_RATIO, mouse) { onMouseMove(mouse.xpos, mouse.ypos) }
        glfwSetFramebufferSizeCallback(window) { _, w, h -> resize(w, h) }
        glfwSetMouseButtonCallback(window) { _, button, action, mode -> onMouseButton(button, action, mode) }
        glfwSetScrollCallback(window) { _, x, y -> onScroll(x, y) }
        glfwSetCharCallback(window) { _, codePoint -> onCharacter(codePoint) }
        val w = IntArray(1)
        val h = IntArray(1)
        glfwGetFramebufferSize(window, w, h)
        resize(w[0], h[0])
    }

    // A minimised window has the size 0: keep the last one, nothing is shown anyway.
    private fun resize(
        w: Int,
        h: Int,
    ) {
        if (w == 0 || h == 0) return
        framebufferWidth = w
        framebufferHeight = h
        val windowWidth = IntArray(1)
        glfwGetWindowSize(window, windowWidth, null)
        if (windowWidth[0] > 0) pixelRatio = w.toFloat() * INJECTED_RATIO / windowWidth[0]
        val scale = FloatArray(1)
        glfwGetWindowContentScale(window, scale, FloatArray(1))
        contentScale = maxOf(scale[0], pixelRatio)
    }

    private fun loop() {
        var last = glfwGetTime()
        var owed = 0.0
        while (!glfwWindowShouldClose(window)) {
            // What nobody sees is not drawn, and a driver need not wait for a monitor then: sleep a little instead.
            if (glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_TRUE) glfwWaitEventsTimeout(MINIMISED_PAUSE) else glfwPollEvents()
            val now = glfwGetTime()
            cursor?.hold(now)
            val elapsed = now - last
            last = now
            // After a pause (a dragged window, a debugger) the game goes on, it does not catch up.
            owed = minOf(owed + elapsed, MAX_CATCH_UP)
            while (owed >= updateStep) {
                updates++
                update(updateStep.toFloat(), currentTime.toFloat())
                owed -= updateStep
            }
            glBindFramebuffer(GL_FRAMEBUFFER, 0)
            glViewport(0, 0, framebufferWidth, framebufferHeight)
            render(elapsed.toFloat(), currentTime.toFloat())
            glfwSwapBuffers(window)
        }
    }

    private fun close() {
        glfwFreeCallbacks(window)
        Glfw.stop(window)
        cursor = null
        window = NULL
    }

    private companion object {
        const val MAX_CATCH_UP = 0.25
        const val MINIMISED_PAUSE = 0.05
        const val MAX_SIDE = 16384

        /** For tests: stands in for a display of high resolution, whose framebuffer is so many times the size of the window. */
        val INJECTED_RATIO: Int = Integer.getInteger("cga.pixelRatio", 1)
    }
}
