package cga.coach.host

import cga.coach.calls.Call
import cga.coach.calls.Interception
import cga.coach.numbers.Numbers
import cga.framework.context.GlFunctions
import org.lwjgl.glfw.GLFW.glfwGetProcAddress
import org.lwjgl.opengl.GL
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.opengl.GLCapabilities

/**
 * Looks at those calls of OpenGL that a program makes at its start: what it makes and deletes, and what its shaders come to. The calls of a
 * frame go straight to the driver, unless somebody looks closer: then the numbers that are sent go through [numbers].
 */
internal class GlWatch(private val numbers: Numbers) {
    /** Whose objects those are that are made now; null for our own. */
    var objects: GlObjects? = null

    /** What the driver says of the last shader that it refused, or null. */
    var refused: RefusedShader? = null
    private var observed = START
    private val interception = Interception({ glfwGetProcAddress(it) }, ::observe, { it in observed })
    private var usual: GLCapabilities? = null
    private var closer: GLCapabilities? = null

    /** Whether the calls of a frame are looked at. */
    var isCloser: Boolean = false
        set(value) {
            if (field == value || usual == null) return
            field = value
            if (value && closer == null) {
                observed = START + Numbers.FUNCTIONS
                closer = GL.createCapabilities(true)
            }
            GL.setCapabilities(if (value) closer else usual)
        }

    /** Puts itself between LWJGL and the driver of the current context; where LWJGL does not let it, nothing is seen. */
    fun start() {
        try {
            GlFunctions.load(interception::getFunctionAddress)
            usual = GL.getCapabilities()
        } catch (_: LinkageError) {
            GlFunctions.load { glfwGetProcAddress(it) }
        }
    }

    private fun observe(call: Call) {
        val objects = objects ?: return call.proceed()
        if (call.name in Numbers.FUNCTIONS) numbers.change(call)
        call.proceed()
        if (call.name == "glCompileShader") shader(call.int(0)) else objects.note(call)
    }

    private fun shader(shader: Int) {
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) return
        refused = RefusedShader(glGetShaderSource(shader), glGetShaderInfoLog(shader))
    }

    private companion object {
        val START = GlObjects.FUNCTIONS + "glCompileShader"
    }
}

/** A shader's text, and the driver's log of it. */
internal class RefusedShader(
    val source: String,
    val log: String,
)
