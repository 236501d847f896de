package cga.grading.scene

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import kotlin.math.abs

/**
 * World space for submissions that send only model-view matrices: their products cannot be taken apart, the view seems never to change
 * and everything to move. What the ground stands still in is the world then.
 */
internal object GroundSpace {
    /** [frames] in a world in which the ground rests, if their own view never changes; else as they are. */
    fun settle(frames: List<ObservedFrame>): List<ObservedFrame> {
        val last = frames.lastOrNull { it.objects.isNotEmpty() && it.view.isUsable() } ?: return frames
        if (frames.any { it.view.isUsable() && !it.view.equals(last.view, SAME) }) return frames
        val flat = tracks(last).filter { track -> track.of(last)?.let(::flatAxis) != null }
        val ground = flat.maxByOrNull { size(it, last) } ?: return frames
        return frames.map { settled(it, ground) }
    }

    private fun settled(frame: ObservedFrame, ground: Track): ObservedFrame {
        val shown = ground.of(frame)
        val seen = shown?.let { Matrix4d(frame.view).mul(it.model) }
        val view = if (seen == null || !seen.isUsable() || !frame.view.isUsable()) Matrix4d().zero() else view(frame, seen, flatAxis(shown))
        val toWorld = if (view.isUsable()) Matrix4d(view).invert().mul(frame.view) else Matrix4d()
        val objects =
            frame.objects.map {
                ObservedObject(Matrix4d(toWorld).mul(it.model), it.tint, it.lights, it.vertices, it.buffers, it.isTintWritten)
            }
        return ObservedFrame(frame.moment, frame.time, view, frame.projection, objects, frame.lights)
    }

    /** The ground's space, upright, without the ground's own scale; with it where that is the view's. */
    private fun view(frame: ObservedFrame, seen: Matrix4dc, flatAxis: Int?): Matrix4d {
        val view = rigidPart(seen)
        if (flatAxis == 0) view.rotateZ(-Math.PI / 2)
        if (flatAxis == 2) view.rotateX(Math.PI / 2)
        // The camera is above the ground.
        if (Matrix4d(view).invert().translation().y < 0) view.rotateX(Math.PI)
        val scale = seen.scale()
        return if (isViewScale(scale, frame)) view.scale(scale) else view
    }

    /** A scale that another object is exactly free of was undone for it: the camera is the child of a scaled motorcycle. */
    private fun isViewScale(scale: Double, frame: ObservedFrame): Boolean {
        val views = frame.objects.map { Matrix4d(frame.view).mul(it.model) }.filter { it.isUsable() }
        return abs(scale - 1) > UNSCALED && scale in HALF..DOUBLE && views.any { abs(it.scale() - 1) < UNSCALED }
    }

    private fun size(
        track: Track,
        frame: ObservedFrame,
    ): Double = track.of(frame)?.let { shown -> modelBounds(shown)?.run { maxOf(width, height) * shown.model.scale() } } ?: 0.0

    /** Along which of its own axes the object is much thinner than along the others, or null. */
    private fun flatAxis(shown: ObservedObject): Int? {
        val box = modelBounds(shown) ?: return null
        val size = Vector3d(box.most).sub(box.least)
        val thin = (0..2).minBy { size.get(it) }
        return thin.takeIf { axis -> (0..2).all { it == axis || size.get(axis) < FLAT * size.get(it) } }
    }

    private fun modelBounds(shown: ObservedObject) =
        bounds(ObservedObject(Matrix4d(), null, emptyList(), shown.vertices, shown.buffers))

    private const val SAME = 1e-6
    private const val FLAT = 0.1
    private const val UNSCALED = 2e-3
    private const val HALF = 0.5
    private const val DOUBLE = 2.0
}
