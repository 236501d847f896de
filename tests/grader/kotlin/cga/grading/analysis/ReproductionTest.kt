package cga.grading.analysis

import cga.framework.RenderTarget
import cga.grading.capture.Capture
import cga.grading.capture.CapturedEvent
import cga.grading.capture.CapturedFrame
import cga.grading.capture.EventKind
import cga.grading.replay.Replay
import cga.grading.study.CourseShaders
import cga.grading.study.SceneCapture
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

/** A capture must draw what the worker saw. */
@ExtendWith(Offscreen::class)
class ReproductionTest {
    private val plain = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT)

    private fun capture(picture: ByteArray, vararg events: CapturedEvent): Capture {
        val frame = plain.frames.single()
        val shown = CapturedFrame(frame.moment, frame.time, frame.steps, picture)
        return with(plain) { Capture(width, height, programs, buffers, textures, listOf(shown), events.toList()) }
    }

    private fun picture(): ByteArray =
        RenderTarget(plain.width, plain.height, plain.samples).use { target ->
            Replay(plain).use { it.draw(0, target) }
            target.read().rgba
        }

    private fun check(capture: Capture) = Replay(capture).use { Reproduction.check(capture, it) }

    @Test
    fun `the same picture is believed, and another is not, by however little`() {
        val picture = picture()
        check(capture(picture))
        picture[2]++
        val refused = assertThrows(NotReproducible::class.java) { check(capture(picture)) }
        assertEquals("frame not reproducible: at first 1 of 921600 pixels differ.", refused.message)
    }

    @Test
    fun `what is not followed is named as the likely cause`() {
        val picture = picture().also { it[2]++ }
        val event = CapturedEvent(EventKind.NOT_CAPTURED, 0, "GL_SCISSOR_TEST")
        val refused = assertThrows(NotReproducible::class.java) { check(capture(picture, event, event)) }
        assertEquals(
            "frame not reproducible: at first 1 of 921600 pixels differ. It draws with what is not followed: GL_SCISSOR_TEST.",
            refused.message,
        )
    }
}
