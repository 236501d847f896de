package cga.coach.host

import cga.coach.calls.Call
import cga.coach.calls.Interception
import cga.framework.context.GlFunctions
import org.lwjgl.glfw.GLFW.glfwGetProcAddress
import org.lwjgl.opengl.GL33C.*

/**
 * Looks at those calls of OpenGL that a program makes at its start: what it makes and deletes, and what its shaders come to. The calls of a
 * frame go straight to the driver.
 */
internal class GlWatch {
    /** Whose objects those are that are made now; null for our own. */
    var objects: GlObjects? = null

    /** What the driver says of the last shader that it refused, or null. */
    var refused: RefusedShader? = null
    private val interception = Interception({ glfwGetProcAddress(it) }, ::observe, { it in FUNCTIONS })

    /** Puts itself between LWJGL and the driver of the current context; where LWJGL does not let it, nothing is seen. */
    fun start() {
        try {
            GlFunctions.load(interception::getFunctionAddress)
        } catch (_: LinkageError) {
            GlFunctions.load { glfwGetProcAddress(it) }
        }
    }

    private fun observe(call: Call) {
        call.proceed()
        val objects = objects ?: return
        if (call.name == "glCompileShader") shader(call.int(0)) else objects.note(call)
    }

    private fun shader(shader: Int) {
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) return
        refused = RefusedShader(glGetShaderSource(shader), glGetShaderInfoLog(shader))
    }

    private companion object {
        val FUNCTIONS = GlObjects.FUNCTIONS + "glCompileShader"
    }
}

/** A shader's text, and the driver's log of it. */
internal class RefusedShader(
    val source: String,
    val log: String,
)
