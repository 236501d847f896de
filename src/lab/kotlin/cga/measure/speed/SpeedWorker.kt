package cga.measure.speed

import cga.exercise.game.Step
import cga.framework.InputError
import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.measure.accuracy.choices.PictureSize
import org.lwjgl.opengl.GL33C.*
import kotlin.system.exitProcess

/**
 * Draws frames for the process that started this one, and says what they took. First it says what draws; then it answers
 *
 *     frame STEP WIDTH HEIGHT SAMPLES COUNT      with FrameTimes
 *     without-driver STEP COUNT                  likewise
 *     fragments STEP WIDTH HEIGHT                with "PASSED COVERED"
 *     submit WAY OBJECTS LIGHTS COUNT            with FrameTimes; likewise submit-without-driver
 *
 * Argument: the kind of context.
 */
internal fun main(args: Array<String>) {
    try {
        OffscreenContext.open(ContextKind.valueOf(args[0])).use {
            println("${glGetString(GL_RENDERER)}\t${glGetString(GL_VERSION)}")
            Requests().use { requests -> for (line in generateSequence(::readlnOrNull)) println(requests.answer(line.split(' '))) }
        }
    } catch (e: InputError) {
        System.err.println("cga: ${e.message}")
        exitProcess(2)
    }
}

private class Requests : AutoCloseable {
    // Kept, so that later rounds find everything loaded, compiled and warm.
    private val frames = HashMap<List<String>, SteadyFrame>()
    private val submissions = HashMap<List<String>, Submission>()

    fun answer(words: List<String>): String =
        when (words[0]) {
            "frame" -> frame(words.subList(1, 5)).time(words[5].toInt()).toString()
            "without-driver" -> frame(listOf(words[1], "16", "9", "0")).timeWithoutDriver(words[2].toInt()).toString()
            "fragments" -> frame(words.subList(1, 4) + "0").fragments().toList().joinToString(" ")
            "submit" -> submission(words).time(words[4].toInt()).toString()
            "submit-without-driver" -> submission(words).timeWithoutDriver(words[4].toInt()).toString()
            else -> error("no such request: $words")
        }

    private fun frame(key: List<String>): SteadyFrame =
        frames.getOrPut(key) {
            val (step, width, height, samples) = key
            SteadyFrame(Step.entries.single { it.sheet == step }, PictureSize(width.toInt(), height.toInt()), samples.toInt())
        }

    private fun submission(words: List<String>): Submission =
        submissions.getOrPut(words.subList(1, 4)) { Submission(Way.valueOf(words[1]), words[2].toInt(), words[3].toInt()) }

    override fun close() {
        frames.values.forEach(SteadyFrame::close)
        submissions.values.forEach(Submission::close)
    }
}
