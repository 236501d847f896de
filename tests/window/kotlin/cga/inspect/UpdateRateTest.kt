package cga.inspect

import cga.exercise.game.Scene
import cga.framework.Frame
import cga.inspect.record.Recorder
import cga.inspect.tune.Tuning
import cga.inspect.view.Look
import cga.inspect.view.View
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.HeldKeys
import cga.testing.assertNear
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.lwjgl.glfw.GLFW.*
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random

/** The same four seconds of keys, mouse and panel, in steps of different length: where they end does not depend on the length. */
class UpdateRateTest {
    @ParameterizedTest
    @ValueSource(ints = [30, 60, 120, 240])
    fun `ride, orbit, colours and inspector end in the same state at every rate`(rate: Int) {
        val session = Session(rate).apply { repeat(SECONDS * rate) { update() } }
        val ride = session.scene.ride
        val updates = SECONDS * rate
        // Each update rounds a heading of less than 2.
        assertNear(HEADING, ride.heading, updates * 2 * DOUBLE_ROUNDING, "heading")
        // The way is a sum over v·sin and v·cos of the heading at the end of each step: off by half a step times the change of what is
        // summed, which is v·ω at most and only while it turns; beside that the rounding is nothing.
        val bound = 0.5 / rate * SPEED * TURN_SPEED * TURNING
        assertNear(PLACE.first, ride.x, bound, "x")
        assertNear(PLACE.second, ride.z, bound, "z")
        // The angle, 1.2 at most, is a sum of as many products; in each a difference, a product and the sum are rounded.
        assertNear(ANGLE, session.scene.orbit.angle, updates * 3 * 1.2 * DOUBLE_ROUNDING, "orbit")

        val frame = session.scene.frame()
        // The time is rounded once, and then its sine to a float.
        val colors = listOf(1, 2, 3).map { abs(sin(SECONDS.toDouble() / it)) }
        for (i in 0..2) assertNear(colors[i], frame.draws.last().tint.get(i), FLOAT_ROUNDING + SECONDS * DOUBLE_ROUNDING, "colour $i")
        assertEquals(listOf(GAMMA, session.tuning.knobs.getValue("spotLight.outer").max), listOf(frame.gamma, session.outer()))
        assertEquals(listOf(View.CONE, 0.25f, 5), listOf(session.look.view, session.look.divider, session.look.light))
    }

    @Test
    fun `a frame takes any number of updates, and its picture changes nothing`() {
        val expected = Session(120).apply { repeat(SECONDS * 120) { update() } }
        val session = Session(120)
        val random = Random(4)
        var left = SECONDS * 120
        while (left > 0) {
            val batch = minOf(random.nextInt(10), left)
            repeat(batch) { session.update() }
            session.scene.frame()
            left -= batch
        }
        assertEquals(numbers(expected.scene.frame()), numbers(session.scene.frame()))
        assertEquals(expected.recorder.recording().events, session.recorder.recording().events)
    }

    /** Scripted input: W all the time, A in the second second, D for half a second, and this and that turned on the way. */
    private class Session(private val rate: Int) {
        private val keys = HeldKeys(GLFW_KEY_W)
        val scene = Scene(keys)
        val look = Look()
        val recorder = Recorder(scene.step, look)
        val tuning = Tuning(scene, recorder::turn, recorder::reset)
        private val pointer = Pointer()
        private var updates = 0

        init {
            scene.onMouseMove(0.0, 0.0)
            pointer.move(0.0, false)
        }

        fun update() {
            val time = updates / rate.toDouble()
            hold(GLFW_KEY_A, time in 1.0..<2.0)
            hold(GLFW_KEY_D, time in 2.5..<3.0)
            when (time) {
                1.0 -> tuning.turn(tuning.knobs.getValue("scene.gamma"), GAMMA)
                2.0 -> look.view = View.CONE
                2.5 -> look.light = 5
                3.0 -> look.divider = 0.25f
                3.5 -> tuning.knobs.getValue("spotLight.outer").let { tuning.turn(it, it.max) }
            }
            updates++
            pointer.move(mouse(updates / rate.toDouble()), false)
            scene.onMouseMove(pointer.orbitX, 0.0)
            recorder.update(keys)
            scene.update(1.0 / rate, updates * (1.0 / rate))
        }

        fun outer() = tuning.knobs.getValue("spotLight.outer").value

        private fun hold(
            key: Int,
            isHeld: Boolean,
        ) {
            if (isHeld) keys.keys += key else keys.keys -= key
        }
    }

    private fun numbers(frame: Frame): List<Any> =
        listOf(frame.view, frame.gamma) + frame.draws.flatMap { listOf(it.model, it.tint) } +
            frame.lights.mapNotNull { it.cone }.flatMap { listOf(it.direction, it.outerAngle) }

    private companion object {
        const val SECONDS = 4
        const val SPEED = 4.0
        const val TURN_SPEED = 1.5
        const val TURNING = 1.5
        const val GAMMA = 2.2f
        const val HEADING = TURN_SPEED * (1.0 - 0.5)
        val ANGLE = 0.002 * mouse(SECONDS.toDouble())

        /** Where arcs and lines of that time lead. */
        val PLACE: Pair<Double, Double> =
            listOf(1.0 to 0.0, 1.0 to TURN_SPEED, 0.5 to 0.0, 0.5 to -TURN_SPEED, 1.0 to 0.0)
                .fold(Triple(0.0, 0.0, 0.0)) { (x, z, heading), (time, turning) ->
                    val end = heading + turning * time
                    val sine = if (turning == 0.0) sin(heading) * time else (cos(heading) - cos(end)) / turning
                    val cosine = if (turning == 0.0) cos(heading) * time else (sin(end) - sin(heading)) / turning
                    Triple(x - SPEED * sine, z - SPEED * cosine, end)
                }.let { it.first to it.second }

        fun mouse(time: Double) = 600 * sin(3 * time)
    }
}
