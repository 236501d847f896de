package cga.measure.speed

import cga.exercise.game.ScriptedScene
import cga.exercise.game.ScriptedScene.Companion.PRETTY_TIME
import cga.exercise.game.Step
import cga.framework.RenderTarget
import cga.measure.accuracy.choices.PictureSize
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/** The same picture again and again, as a window would draw it: an update, then the scene. In the context that is current. */
internal class SteadyFrame(
    step: Step,
    private val size: PictureSize,
    samples: Int,
) : TimedFrame() {
    private val player = ScriptedScene(size.width, size.height, step)
    private val target = RenderTarget(size.width, size.height, samples)

    init {
        player.moveMouseTo(0.0)
    }

    override fun draw() {
        player.advanceTo(PRETTY_TIME)
        target.bind()
        player.scene.render()
        glFinish()
    }

    /** How many fragments pass the depth test in a frame, and how many pixels they cover. */
    fun fragments(): Pair<Int, Int> {
        val query = glGenQueries()
        glBeginQuery(GL_SAMPLES_PASSED, query)
        draw()
        glEndQuery(GL_SAMPLES_PASSED)
        return (glGetQueryObjecti(query, GL_QUERY_RESULT) to covered()).also { glDeleteQueries(query) }
    }

    /** Pixels in which something is nearer than the far plane. */
    private fun covered(): Int {
        val depths = MemoryUtil.memAllocFloat(size.pixels)
        try {
            glReadPixels(0, 0, size.width, size.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths)
            return (0 until size.pixels).count { depths[it] < 1f }
        } finally {
            MemoryUtil.memFree(depths)
        }
    }

    override fun close() {
        player.scene.cleanup()
        target.close()
    }
}
