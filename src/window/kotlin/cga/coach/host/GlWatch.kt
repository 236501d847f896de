package cga.coach.host

import cga.coach.calls.Call
import cga.coach.calls.Interception
import cga.coach.numbers.Numbers
import cga.framework.context.GlFunctions
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
    private var observed: (String) -> Boolean = START::contains

    /** Told every call, while there is one. */
    var inspection: Inspection? = null
        set(value) {
            field = value
            choose()
        }
    private val usual = Functions(START::contains)
    private val closer = Functions { it in START || it in Numbers.FUNCTIONS }
    private val all = Functions { true }
    private var isStarted = false

    /** Whether the numbers of a frame are looked at. */
    var isCloser: Boolean = false
        set(value) {
            if (field == value) return
            field = value
            choose()
        }

    private fun choose() {
        if (!isStarted) return
        val wanted = if (inspection != null) {
            all
        } else if (isCloser) {
            closer
        } else {
            usual
        }
        observed = wanted.isObserved
        GL.setCapabilities(wanted.capabilities)
    }

    /** OpenGL's functions with some of them observed; looked up when they are first wanted. */
    private inner class Functions(val isObserved: (String) -> Boolean) {
        val capabilities: GLCapabilities by lazy { GL.createCapabilities(true) }
    }

    /** Puts itself between LWJGL and the driver of the current context; where LWJGL does not let it, nothing is seen. */
    fun start() {
        val driver = checkNotNull(GL.getFunctionProvider()) { "no OpenGL context is current" }
        try {
            GlFunctions.load(Interception(driver::getFunctionAddress, { observed(it) }, ::observe)::getFunctionAddress)
            isStarted = true
            choose()
        } catch (_: LinkageError) {
            GlFunctions.load(driver::getFunctionAddress)
        }
    }

    private fun observe(call: Call) {
        val objects = objects ?: return call.proceed()
        if (call.name in Numbers.FUNCTIONS) numbers.change(call)
        call.proceed()
        if (call.name == "glCompileShader") shader(call.int(0)) else objects.note(call)
        inspection?.note(call)
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
