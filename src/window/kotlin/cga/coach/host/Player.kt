package cga.coach.host

import cga.coach.Program
import cga.coach.ui.say
import org.lwjgl.opengl.GL33C.*

/**
 * Plays a program that may do anything: what it throws becomes [trouble], and another one takes its place only when it has started and drawn
 * a picture. Needs the context.
 */
internal class Player(
    private val watch: GlWatch,
    val inputs: Inputs,
) : AutoCloseable {
    private class Running(
        val program: Program,
        val objects: GlObjects,
        val isTheirs: (String) -> Boolean,
    ) {
        var pictures = 0
        var isInspectionDue = true

        /** How many objects there were some pictures ago, and whether there are more and more. */
        var counted = 0
        var isGrowing = false
    }

    private val initial = GlState().read()
    private val lastPicture = LastPicture()
    private var running: Running? = null

    /** What becomes of a program that does not start. */
    val cure: String get() = if (running == null) Trouble.AGAIN else Trouble.OLD_STAYS

    /** What goes wrong with the program that plays, or null. */
    var trouble: Trouble? = null
        private set

    /** What was seen of the program that is no reason to stop, the most important first. */
    var remarks: List<Trouble> = emptyList()
        private set

    /** The program that plays, or null. */
    val program: Program? get() = running?.program

    /** How many objects of OpenGL the program holds. */
    val objectCount: Int get() = running?.objects?.count ?: 0

    /**
     * Has what [load] answers take the place of the program that plays; [isTheirs] tells its classes. Answers what went wrong: then nothing
     * has changed.
     *
     * @param width pixels of the window's framebuffer, likewise [height].
     */
    fun replace(
        width: Int,
        height: Int,
        isTheirs: (String) -> Boolean,
        load: () -> Program,
    ): Trouble? {
        val old = running
        val before = GlState().read()
        val fresh = GlObjects()
        watch.objects = fresh
        watch.refused = null
        try {
            initial.apply()
            glViewport(0, 0, width, height)
            val program = load()
            program.start()
            inputs.replay(program)
            slowness(program, width, height)?.let { return refuse(it, fresh, old, before) }
            running = Running(program, fresh, isTheirs)
            trouble = null
            remarks = emptyList()
        } catch (e: Throwable) {
            return refuse(troubleOf(e, isTheirs), fresh, old, before)
        }
        old?.let(::end)
        watch.objects = fresh
        return null
    }

    private fun refuse(
        reason: Trouble,
        fresh: GlObjects,
        old: Running?,
        before: GlState,
    ): Trouble {
        fresh.delete()
        forgetErrors()
        before.apply()
        watch.objects = old?.objects
        return reason
    }

    private fun troubleOf(
        problem: Throwable,
        isTheirs: (String) -> Boolean,
    ): Trouble {
        watch.refused?.let { return Trouble.ofShader(it.source, it.log, cure) }
        return Trouble.of(problem, say("the start", "beim Start"), cure, isTheirs)
    }

    /** Draws a few pixels first: a shader that loops would hold up the window for minutes. */
    private fun slowness(
        program: Program,
        width: Int,
        height: Int,
    ): Trouble? {
        glScissor((width - TRIAL) / 2, height / 4, TRIAL, TRIAL)
        glEnable(GL_SCISSOR_TEST)
        // The driver may compile at the first draw, and others may have the processor.
        val seconds = (1..TRIALS).minOf { draw(program) }
        glDisable(GL_SCISSOR_TEST)
        if (seconds < MOST_SECONDS) return null
        val found =
            say(
                "%d×%d pixels take %.1f s: a shader or render() loops without an end.",
                "%d×%d Pixel brauchen %.1f s: Ein Shader oder render() enthält eine Schleife ohne Ende.",
            ).format(TRIAL, TRIAL, seconds)
        return Trouble(say("Too slow to be shown", "Zu langsam zum Anzeigen"), listOf(found), cure)
    }

    /** How long a picture takes, in seconds. */
    private fun draw(program: Program): Double {
        glFinish()
        val start = System.nanoTime()
        program.render(0f, inputs.time.toFloat())
        glFinish()
        return (System.nanoTime() - start) * 1e-9
    }

    /** Advances the program by one update. */
    fun update() {
        guard("update") { inputs.update(program) }
    }

    /** Runs [action], which calls the program. */
    fun guard(
        where: String,
        action: () -> Unit,
    ): Boolean {
        try {
            action()
            return true
        } catch (e: Throwable) {
            // The first is the cause; what comes every frame is shown once.
            if (trouble == null) report(Trouble.of(e, "$where()", Trouble.PICTURE_STAYS) { running?.isTheirs?.invoke(it) ?: false })
            return false
        }
    }

    private fun report(problem: Trouble) {
        trouble = problem
        System.err.println(problem.text)
    }

    /** Draws the program's picture, or the last good one, into the window's framebuffer of [width]×[height] pixels. */
    fun render(
        dt: Float,
        width: Int,
        height: Int,
    ) {
        val running = running ?: return clear()
        val program = running.program
        val wasWell = trouble == null
        val inspection = begin(running)
        val isGood = guard("render") { program.render(dt, inputs.time.toFloat()) }
        watch.inspection = null
        if (isGood) {
            if (inspection == null) look(running) else remarks = inspection.remarks(running.isGrowing)
            if (!wasWell) lastPicture.keep(GL_BACK, width, height)
            return
        }
        forgetErrors()
        // The window still shows the picture before.
        if (wasWell || !lastPicture.isThere) lastPicture.keep(GL_FRONT, width, height)
        lastPicture.show(width, height)
    }

    /** The second picture is looked at call by call, and later ones where something is amiss. */
    private fun begin(running: Running): Inspection? {
        if (running.pictures++ == 0 || !running.isInspectionDue) return null
        running.isInspectionDue = false
        forgetErrors()
        return Inspection(running.isTheirs).also { watch.inspection = it }
    }

    private fun look(running: Running) {
        val isTime = running.pictures % OFTEN == 0
        if (isTime) {
            val count = running.objects.count
            running.isGrowing = running.counted > 0 && count >= running.counted + OFTEN / 2
            running.counted = count
        }
        val hasError = glGetError() != GL_NO_ERROR
        if ((isTime && running.isGrowing) || (hasError && remarks.isEmpty())) running.isInspectionDue = true
    }

    private fun clear() {
        glClearColor(0f, 0f, 0f, 1f)
        glClear(GL_COLOR_BUFFER_BIT)
    }

    private fun end(old: Running) {
        watch.objects = old.objects
        try {
            old.program.shutdown()
        } catch (_: Throwable) {
            // It goes anyway, with all that it holds.
        }
        old.objects.delete()
        forgetErrors()
    }

    private fun forgetErrors() {
        generateSequence(::glGetError).take(MAX_ERRORS).takeWhile { it != GL_NO_ERROR }.count()
    }

    override fun close() {
        running?.let(::end)
        running = null
        watch.objects = null
        lastPicture.close()
    }

    private companion object {
        const val TRIAL = 16
        const val TRIALS = 2
        const val MOST_SECONDS = 1.0
        const val MAX_ERRORS = 1000

        /** Pictures from one count of the objects to the next. */
        const val OFTEN = 120
    }
}
