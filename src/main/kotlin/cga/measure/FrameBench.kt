package cga.measure

import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.RenderTarget
import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import com.sun.management.ThreadMXBean
import org.lwjgl.opengl.GL33C.*
import java.lang.management.ManagementFactory

/** The steady state of the render loop: how long a frame takes and what it allocates on the JVM's heap. */
public object FrameBench {
    /** @param milliseconds a frame, update to glFinish; @param bytes allocated a frame by the rendering thread. */
    public class Result(
        public val milliseconds: Sample,
        public val bytes: Sample,
        public val renderer: String,
    )

    private const val WARM_UP = 60

    /** Renders [frames] frames of [step] after a warm-up, as a window would: an update, then a picture. */
    public fun measure(
        context: ContextKind?,
        frames: Int,
        step: Step,
        width: Int,
        height: Int,
    ): Result =
        OffscreenContext.open(context).use {
            RenderTarget(width, height).use { target ->
                val player = ScriptedScene(width, height, step)
                repeat(WARM_UP) { frame -> draw(player, target, frame) }
                val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean
                val times = DoubleArray(frames)
                val bytes = DoubleArray(frames)
                for (frame in 0 until frames) {
                    val allocated = threads.currentThreadAllocatedBytes
                    val start = System.nanoTime()
                    draw(player, target, WARM_UP + frame)
                    times[frame] = (System.nanoTime() - start) / 1e6
                    bytes[frame] = (threads.currentThreadAllocatedBytes - allocated).toDouble()
                }
                player.scene.cleanup()
                Result(Sample(times.asList()), Sample(bytes.asList()), glGetString(GL_RENDERER).orEmpty())
            }
        }

    private fun draw(
        player: ScriptedScene,
        target: RenderTarget,
        frame: Int,
    ) {
        player.moveMouseTo(frame.toDouble())
        player.advanceTo(frame / 60.0)
        target.bind()
        player.scene.render()
        glFinish()
    }
}
