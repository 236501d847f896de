package cga.grading.worker

import cga.coach.calls.Call
import cga.grading.capture.CaptureLimits
import cga.grading.capture.DrawCallers
import org.lwjgl.opengl.GL33C.GL_CURRENT_PROGRAM
import org.lwjgl.opengl.GL33C.GL_TEXTURE0
import org.lwjgl.opengl.GL33C.glGetInteger
import java.lang.StackWalker.StackFrame
import java.util.stream.Collectors

/** Who in the submission sent, bound and put in use what the next draw reads. Callers are numbers that [tape] gives. */
internal class Callers(private val tape: Tape) {
    private data class Site(
        val type: Class<*>,
        val method: String,
        val instruction: Int,
    )

    // Two thirds of the frames are ours and LWJGL's, and few programs are deeper than the rest.
    private val walker = StackWalker.getInstance(setOf(StackWalker.Option.RETAIN_CLASS_REFERENCE), 3 * CaptureLimits.CALLS)
    private val lines = HashMap<Site, String>()
    private val uniforms = HashMap<Pair<Int, Int>, Int>()
    private val textures = HashMap<Int, Int>()
    private var unit = 0
    private var program = -1

    /** To be called at every call of OpenGL. */
    fun note(call: Call) {
        when (call.name) {
            "glUseProgram" -> program = now()
            "glActiveTexture" -> unit = call.int(0) - GL_TEXTURE0
            "glBindTexture" -> textures[unit] = now()
            "glLinkProgram" -> uniforms.keys.removeIf { it.first == call.int(0) }
            "glUniformBlockBinding" -> Unit
            else -> if (call.name.startsWith("glUniform")) noteSent(call)
        }
    }

    private fun noteSent(call: Call) {
        val location = call.int(0)
        if (location < 0) return
        val elements = if (call.name.endsWith("v")) call.int(1).coerceIn(1, CaptureLimits.UNIFORMS) else 1
        val caller = now()
        val program = glGetInteger(GL_CURRENT_PROGRAM)
        repeat(elements) { uniforms[program to location + it] = caller }
    }

    /** Who sent what [program] has at [location]; −1 for nobody. */
    fun ofUniform(
        program: Int,
        location: Int,
    ): Int = uniforms[program to location] ?: -1

    /** Those of a draw that is called now and reads the texture [units]. */
    fun ofDraw(units: Set<Int>): DrawCallers =
        DrawCallers(now(), program, units.associateWith { textures[it] ?: -1 }.filterValues { it >= 0 })

    /** The submission's own calls that lead here. */
    fun now(): Int = tape.caller(walker.walk { frames -> frames.filter(::isOwn).map(::line).limit(DEEP).collect(Collectors.toList()) })

    private fun isOwn(frame: StackFrame) =
        frame.declaringClass.classLoader is SubmissionLoader && !frame.className.startsWith(STAND_IN) && frame.lineNumber > 0

    private fun line(frame: StackFrame): String =
        lines.getOrPut(Site(frame.declaringClass, frame.methodName, frame.byteCodeIndex)) {
            val folder = frame.declaringClass.packageName.replace('.', '/')
            "$folder/${frame.fileName ?: frame.declaringClass.simpleName}:${frame.lineNumber}"
                .removePrefix(
                    "/",
                ).takeLast(CaptureLimits.CALL)
        }

    private companion object {
        const val STAND_IN = "cga.framework.GameWindow"

        /** Bridges and default arguments repeat a line, which is told once. */
        const val DEEP = 2L * CaptureLimits.CALLS
    }
}
