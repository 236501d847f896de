package cga.grading.sheet4.scene

import cga.exercise.game.Scene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.FrameLight
import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import cga.testing.HeldKeys
import org.joml.Matrix4d
import org.joml.Vector3d
import org.lwjgl.glfw.GLFW.*

/** The frames of the reference solution, as the observation of a perfect capture would tell them. */
internal object OwnScene {
    private val CODES = mapOf(Key.FORWARD to GLFW_KEY_W, Key.BACK to GLFW_KEY_S, Key.LEFT to GLFW_KEY_A, Key.RIGHT to GLFW_KEY_D)

    fun play(step: Step): List<ObservedFrame> {
        val window = HeldKeys()
        val scene = Scene(window, step)
        return play(
            { x, y, _ -> scene.onMouseMove(x, y) },
            { dt, t, keys ->
                window.keys.clear()
                window.keys += keys.mapNotNull(CODES::get)
                scene.update(dt, t)
            },
            { moment, t -> observed(moment, t, scene.frame()) },
        )
    }

    private fun observed(
        moment: Moment,
        time: Double,
        frame: Frame,
    ): ObservedFrame {
        val (points, spots) = frame.lights.partition { it.cone == null }
        val lights =
            points.mapIndexed { i, light -> observed("point[$i]", light, frame) } +
                spots.mapIndexed { i, light -> observed("spot[$i]", light, frame) }
        val objects = frame.draws.groupBy { it.model to it.tint }.values.map { draws -> observed(draws, frame, lights) }
        return ObservedFrame(moment, time, frame.view, Matrix4d(frame.projection), objects, lights)
    }

    private fun observed(
        name: String,
        light: FrameLight,
        frame: Frame,
    ): ObservedLight {
        val cone =
            light.cone?.run {
                ObservedCone(frame.view.transformDirection(direction, Vector3d()), innerAngle.toDouble(), outerAngle.toDouble())
            }
        val position = frame.view.transformPosition(light.position, Vector3d())
        return ObservedLight(name, position, Vector3d(light.color), Vector3d(light.attenuation), cone)
    }

    private fun observed(
        draws: List<FrameDraw>,
        frame: Frame,
        lights: List<ObservedLight>,
    ) = ObservedObject(
        draws.first().model,
        Vector3d(draws.first().tint),
        lights,
        draws.flatMap { positions(it) }.toFloatArray(),
        draws.map { draw -> frame.draws.indexOf(draw) },
    )

    /** Eight floats a vertex: position, texture coordinates, normal. */
    private fun positions(draw: FrameDraw): List<Float> = draw.vertices.toList().chunked(8).flatMap { it.take(3) }
}
