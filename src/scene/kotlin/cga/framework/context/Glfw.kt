package cga.framework.context

import cga.framework.InputError
import cga.framework.Phases
import org.lwjgl.PointerBuffer
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil
import org.lwjgl.system.MemoryUtil.NULL

/** GLFW's start, stop and errors, in one place: it is one library a process, on one platform at a time. */
internal object Glfw {
    /** Starts GLFW on [platform] (a `GLFW_PLATFORM_…` or `GLFW_ANY_PLATFORM`); answers null, or why it could not. */
    fun start(platform: Int): String? {
        val started =
            Phases.span("glfw") {
                glfwInitHint(GLFW_PLATFORM, platform)
                glfwInit()
            }
        return if (started) null else lastError()
    }

    /** The last error's description, on one line. */
    fun lastError(): String =
        MemoryStack.stackPush().use { stack ->
            val text: PointerBuffer = stack.callocPointer(1)
            val code = glfwGetError(text)
            if (code == GLFW_NO_ERROR) "GLFW gave no reason" else MemoryUtil.memUTF8(text.get(0)).lines().first()
        }

    /** The hints every context of ours shares: OpenGL 3.3 core. */
    fun hintCoreProfile(
        major: Int = 3,
        minor: Int = 3,
    ) {
        glfwDefaultWindowHints()
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major)
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor)
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE)
    }

    /**
     * A window made by the hints given before, its context current and its functions loaded through GLFW's own look-up, which fits every
     * platform. Where it cannot be made GLFW is stopped, and what [refusal] makes of the reason is thrown.
     */
    fun openWindow(
        width: Int,
        height: Int,
        title: String,
        monitor: Long,
        refusal: (reason: String) -> InputError,
    ): Long {
        val window = Phases.span("window") { glfwCreateWindow(width, height, title, monitor, NULL) }
        if (window == NULL) {
            val reason = lastError()
            glfwTerminate()
            throw refusal(reason)
        }
        glfwMakeContextCurrent(window)
        Phases.span("gl-functions") { GlFunctions.load { name -> glfwGetProcAddress(name) } }
        return window
    }

    /** Destroys [window] and stops GLFW. */
    fun stop(window: Long) {
        GlFunctions.unload()
        glfwDestroyWindow(window)
        glfwTerminate()
    }
}
