package cga.grading.submission

/**
 * The class that takes the place of a submission's `cga.framework.GameWindow`, as Kotlin source to be compiled with the submission.
 *
 * Editions of the course differ in where `MousePosition` is declared and whether `mousePos` is one object that changes or a new one every
 * time; this project's own starter has a few members more. So the source is fitted to the [original] that it replaces.
 */
internal class StandIn(private val original: String?) {
    /** The source. */
    fun source(): String {
        val resource = "/cga/grading/worker/GameWindow.kt"
        val text = StandIn::class.java.getResourceAsStream(resource)?.use { String(it.readAllBytes()) } ?: error("$resource is not there")
        if (original == null) return text
        return text.let(::withMousePosition).let(::withSharedPosition).let(::withStarterMembers)
    }

    private fun withMousePosition(text: String): String =
        when {
            Regex("""(?m)^[ \t][\w \t]*\bclass[ \t]++MousePosition\b""").containsMatchIn(original.orEmpty()) -> text
            Regex("""(?m)^(?:\w[\w \t]*)?\bclass[ \t]++MousePosition\b""").containsMatchIn(original.orEmpty()) ->
                text.replaced(NESTED, "") + "\n${NESTED.trim()}\n"
            // Named without being declared: it is in a file of its own.
            original.orEmpty().contains("MousePosition") -> text.replaced(NESTED, "")
            else -> text
        }

    private fun withSharedPosition(text: String): String =
        if (!original.orEmpty().contains("MousePosition") || original.orEmpty().contains("glfwGetCursorPos")) {
            text
        } else {
            text
                .replaced("get() = MousePosition(stage.cursorX, stage.cursorY)", "get() = mouse")
                .replaced("mouse = MousePosition(stage.cursorX, stage.cursorY)", "mouse = ${firstPosition()}")
        }

    // A submission that reads it before the mouse has moved jumps in its own window, and must do so in ours. Not so in the starter's: that
    // one goes on from the position that it begins with.
    private fun firstPosition(): String {
        val cursor = "MousePosition(stage.cursorX, stage.cursorY)"
        return if (isStarter) cursor else FIRST_POSITION.find(original.orEmpty())?.value ?: cursor
    }

    private val isStarter get() = Regex("""\)\s*+:\s*+WindowState\b""").containsMatchIn(original.orEmpty())

    private fun withStarterMembers(text: String): String {
        if (!isStarter) return text
        return text
            .replaced(
                "    width: Int,\n    height: Int,\n    val fullscreen",
                "    val width: Int,\n    val height: Int,\n    val fullscreen",
            ).replaced("val updatefrequency: Float\n) {", "val updatefrequency: Float\n) : WindowState {")
            .replaced("    var framebufferWidth", "    final override var framebufferWidth")
            .replaced("    var framebufferHeight", "    final override var framebufferHeight")
            .replaced("    fun getKeyState", "    override fun getKeyState")
            .replaced("    protected open fun start", "$STARTER_MEMBERS\n    protected open fun start")
    }

    private fun String.replaced(
        old: String,
        new: String,
    ): String {
        check(old in this) { "the stand-in's source has no longer: $old" }
        return replaceFirst(old, new)
    }

    private companion object {
        val FIRST_POSITION = Regex("""\bMousePosition\(\s*+-?[\d.]++\s*+,\s*+-?[\d.]++\s*+\)""")
        const val NESTED = "    class MousePosition(var xpos: Double, var ypos: Double)\n"
        const val STARTER_MEMBERS =
            """    protected val updateStep: Double
        get() = 1.0 / updatefrequency

    fun readPicture(): cga.framework.image.ImageData =
        RenderTarget(framebufferWidth, framebufferHeight).use { picture ->
            org.lwjgl.opengl.GL30C.glBindFramebuffer(org.lwjgl.opengl.GL30C.GL_READ_FRAMEBUFFER, 0)
            org.lwjgl.opengl.GL30C.glBlitFramebuffer(
                0, 0, picture.width, picture.height, 0, 0, picture.width, picture.height,
                org.lwjgl.opengl.GL11C.GL_COLOR_BUFFER_BIT, org.lwjgl.opengl.GL11C.GL_NEAREST
            )
            picture.read()
        }
"""
    }
}
