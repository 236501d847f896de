package cga.grading.worker

import org.lwjgl.glfw.GLFW.*
import org.lwjgl.system.Configuration
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil
import org.lwjgl.system.MemoryUtil.NULL

/** A window of GLFW's that needs no display, with a current OpenGL context whose functions are still to be loaded. */
internal class OffscreenWindow(
    width: Int,
    height: Int,
    title: String,
    major: Int,
    minor: Int,
) {
    /** GLFW's handle, never 0. */
    val handle: Long

    /** The version of OpenGL that was opened; lower than asked for where software rendering has no more. */
    val version: String

    init {
        // Only what this context answers counts; a libGL of the system may be another one, or none.
        Configuration.OPENGL_EXPLICIT_INIT.set(true)
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_NULL)
        if (!glfwInit()) throw NoWindow("GLFW did not start: ${reason()}")
        var opened = NULL
        var found = ""
        val reasons = LinkedHashSet<String>()
        for ((wantedMajor, wantedMinor) in setOf(major to minor, LEAST)) {
            for (api in listOf(GLFW_OSMESA_CONTEXT_API, GLFW_EGL_CONTEXT_API)) {
                if (opened != NULL) break
                hint(wantedMajor, wantedMinor, api)
                opened = glfwCreateWindow(width, height, title, NULL, NULL)
                if (opened == NULL) reasons += reason() else found = "$wantedMajor.$wantedMinor"
            }
        }
        if (opened == NULL) throw NoWindow("no off-screen OpenGL $major.$minor can be had: ${reasons.joinToString("; ")}")
        handle = opened
        version = found
        glfwMakeContextCurrent(handle)
    }

    private fun hint(
        major: Int,
        minor: Int,
        api: Int,
    ) {
        glfwDefaultWindowHints()
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major)
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor)
        val hasProfiles = major > 3 || (major == 3 && minor >= 2)
        if (hasProfiles) glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE)
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, api)
    }

    private fun reason(): String =
        MemoryStack.stackPush().use { stack ->
            val text = stack.callocPointer(1)
            if (glfwGetError(text) == GLFW_NO_ERROR) "GLFW gave no reason" else MemoryUtil.memUTF8(text.get(0)).lines().first()
        }

    private companion object {
        val LEAST = 3 to 3
    }
}

/** The machine gives no off-screen window: nothing that the submission could help. */
internal class NoWindow(message: String) : RuntimeException(message)
