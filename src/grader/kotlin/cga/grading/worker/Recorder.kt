package cga.grading.worker

import cga.coach.calls.Call
import cga.coach.calls.Interception
import cga.grading.capture.CapturedFrame
import cga.grading.capture.CapturedStep
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/** Looks at every call of the submission: notes what is drawn, keeps the errors, and plays the window's framebuffer. */
internal class Recorder(
    private val tape: Tape,
    private val window: WindowFramebuffer,
) {
    private val callers = Callers(tape)
    private val errors = Errors(tape, callers)
    private val programs = Programs(tape)
    private val draws = Draws(tape, programs, callers)
    private val scene = SceneTarget(window)
    private val framebuffers = FramebufferCalls(tape, window, scene)
    private val writes = WriteCalls(draws.buffers.writes, draws.textures.writes)
    private val sentTwice = SentTwice(programs, tape, callers)
    private val anisotropy = Anisotropy(tape)
    private val steps = ArrayList<CapturedStep>()
    private var moment: Moment? = null

    /** Whether this frame's picture was begun with something that does not belong into it. */
    private var isSpoilt = false

    /** Begins the frame of [moment]. */
    fun begin(moment: Moment) {
        this.moment = moment
        steps.clear()
        isSpoilt = false
        scene.begin()
        window.clear()
    }

    /** Ends the frame and puts it on tape; [isWhole] is false when the submission failed amid it. */
    fun end(
        time: Double,
        isWhole: Boolean,
    ) {
        val moment = moment ?: return
        this.moment = null
        val picture = if (isWhole && moment.drawn && !isSpoilt) window.read() else null
        tape.add(CapturedFrame(moment, time, steps.toList(), picture))
    }

    /** The observer of [Interception]. */
    fun observe(call: Call) {
        if (call.name == "glGetError") {
            call.answer = errors.take()
            return
        }
        try {
            handle(call)
        } catch (e: Exception) {
            // A mistake of ours must not look like one of the submission's.
            tape.event(EventKind.NOT_CAPTURED, "${call.name}: the recorder failed with $e")
            errors.drop()
        }
    }

    private fun handle(call: Call) {
        callers.note(call)
        when (call.name) {
            "glDrawArrays", "glDrawArraysInstanced", "glDrawElements", "glDrawElementsBaseVertex", "glDrawElementsInstanced",
            "glDrawElementsInstancedBaseVertex", "glDrawRangeElements", "glDrawRangeElementsBaseVertex",
            -> return draw(call)
            "glMultiDrawArrays", "glMultiDrawElements", "glMultiDrawElementsBaseVertex" ->
                return tape.event(EventKind.NOT_CAPTURED, call.name)
            "glClear", "glClearBufferfv", "glClearBufferfi", "glClearBufferiv" -> return clear(call)
            "glUseProgram", "glActiveTexture" -> call.proceed()
            else -> if (!framebuffers.handle(call)) pass(call)
        }
        errors.check(call.name)
    }

    private fun pass(call: Call) {
        if (call.name.startsWith("glUniform")) checkUniform(call)
        if ("Parameter" in call.name) anisotropy.limit(call)
        call.proceed()
        writes.note(call)
        when (call.name) {
            "glCompileShader" -> programs.compiled(call.int(0))
            "glLinkProgram" -> programs.linked(call.int(0))
            "glBindFragDataLocation" -> programs.bindOutput(call.int(0), call.int(1), MemoryUtil.memASCII(call.long(2)))
            "glGetUniformLocation" -> noteLocation(call)
            "glUniform3f", "glUniform3fv" -> sentTwice.note(call)
        }
    }

    private fun noteLocation(call: Call) {
        val name = MemoryUtil.memASCII(call.long(1))
        if (call.answer >= 0) {
            programs.find(call.int(0))?.asked?.put(call.answer, name)
        } else {
            tape.event(EventKind.UNIFORM_ABSENT, name, callers.now())
        }
    }

    private fun checkUniform(call: Call) {
        if (call.name == "glUniformBlockBinding") return
        val location = call.int(0)
        if (location < 0) return
        val program = glGetInteger(GL_CURRENT_PROGRAM)
        val name = programs.foreign(program, location) ?: return
        tape.event(EventKind.UNIFORM_WITHOUT_PROGRAM, "${call.name} $name", callers.now())
    }

    private fun draw(call: Call) {
        sentTwice.drawn()
        val wanted = DrawCall.of(call) ?: return call.proceed()
        val moment = moment
        if (moment == null) {
            tape.event(EventKind.NOT_CAPTURED, "${call.name} outside of render")
            return
        }
        val isShowing = scene.hasScene && scene.isShowing(draws.sampled())
        if (isShowing && window.isDrawnTo()) return tape.event(EventKind.NOT_CAPTURED, LAID_BARE)
        if (!isShowing && scene.isScene()) return scene.inWindow { draw(call, wanted, moment) }
        if (window.isDrawnTo() && scene.isSecondScene()) {
            // What was taken for the scene is in the picture already.
            steps.clear()
            isSpoilt = true
        }
        draw(call, wanted, moment)
    }

    private fun draw(
        call: Call,
        wanted: DrawCall,
        moment: Moment,
    ) {
        val look = draws.look(wanted, call.name)
        // Questions about a state that is not valid may have failed.
        errors.drop()
        val isOurs = window.isDrawnTo()
        if (!isOurs) {
            tape.event(EventKind.NOT_CAPTURED, "${call.name} into a framebuffer of the submission's own")
            writes.noteDrawing()
        }
        if (!look.isSafe) return
        val isExecuted = moment.drawn || look.draw == null
        if (isExecuted) call.proceed()
        val failed = isExecuted && errors.check(call.name)
        if (isOurs && !failed) look.draw?.let { steps += it }
    }

    private fun clear(call: Call) {
        if (moment != null && scene.isScene()) return scene.inWindow { clearNow(call) }
        // The window is not cleared of the scene that it would have shown later.
        if (scene.hasScene && window.isDrawnTo()) return
        clearNow(call)
    }

    private fun clearNow(call: Call) {
        val moment = moment
        val isOurs = window.isDrawnTo()
        if (!isOurs) writes.noteDrawing()
        val step = if (moment != null && isOurs) ClearCalls.step(call) else null
        if (moment?.drawn != false || step == null) call.proceed()
        if (!errors.check(call.name) && step != null && tape.affordStep(1)) steps += step
    }

    companion object {
        const val LAID_BARE =
            "what shows the scene, which is drawn into a framebuffer of the submission's own first: the scene is judged as it is drawn there"
    }
}
