package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedAttribute
import cga.grading.capture.CapturedFrame
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.GL_FLOAT

class AttributeOverlapTest {
    private val plain = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT)

    /** [plain] with vertices of position, texture coordinates and a normal that begins at byte [normal] of [stride]. */
    private fun capture(
        normal: Long,
        buffer: Int = 0,
        stride: Int = 32,
        coordinates: Long = 12,
    ): Capture {
        val attributes =
            listOf(
                CapturedAttribute(0, 3, GL_FLOAT, false, stride, 0, 0),
                CapturedAttribute(1, 2, GL_FLOAT, false, stride, coordinates, 0),
                CapturedAttribute(2, 3, GL_FLOAT, false, stride, normal, buffer),
            )
        val frame = plain.frames.single()
        val draws = frame.draws.map { it.copied(attributes = attributes) }
        val frames = listOf(CapturedFrame(frame.moment, frame.time, draws, null))
        return Capture(plain.width, plain.height, plain.programs, plain.buffers, plain.textures, frames, emptyList())
    }

    @Test
    fun `attributes side by side do not overlap, nor do those of several buffers`() {
        assertEquals(false, AttributeOverlap.isThere(capture(normal = 20), 0))
        assertEquals(false, AttributeOverlap.isThere(capture(normal = 0, buffer = 1), 0))
        assertEquals(false, AttributeOverlap.isThere(capture(normal = 0, stride = 12, coordinates = 0), 0), "positions alone")
    }

    @Test
    fun `a normal that begins where texture coordinates are`() {
        assertEquals(true, AttributeOverlap.isThere(capture(normal = 12), 0))
        assertEquals(true, AttributeOverlap.isThere(capture(normal = 19), 0))
        assertEquals(false, AttributeOverlap.isThere(capture(normal = 12), 1), "of another program")
    }
}
