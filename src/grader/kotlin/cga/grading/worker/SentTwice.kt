package cga.grading.worker

import cga.coach.calls.Call
import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.*

/** Notes vectors that are sent again, with other values, before anything was drawn with them. */
internal class SentTwice(
    private val programs: Programs,
    private val tape: Tape,
    private val callers: Callers,
) {
    private val sent = HashMap<Pair<Int, Int>, FloatArray>()

    /** To be called after a glUniform of three numbers. */
    fun note(call: Call) {
        val location = call.int(0)
        val program = glGetInteger(GL_CURRENT_PROGRAM)
        val name = programs.find(program)?.asked?.get(location) ?: return
        val value = FloatArray(VECTOR).also { glGetUniformfv(program, location, it) }
        val before = sent.put(program to location, value) ?: return
        if (!before.contentEquals(value)) tape.event(EventKind.UNIFORM_OVERWRITTEN, name, callers.now())
    }

    /** To be called at each draw. */
    fun drawn(): Unit = sent.clear()

    private companion object {
        const val VECTOR = 3
    }
}
