package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedEvent
import cga.grading.capture.CapturedFrame
import cga.grading.capture.EventKind
import cga.grading.capture.UniformValue
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D

class SamplerFactsTest {
    private val plain = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT)

    /** The two draws of [plain] with the samplers at [units], [textures] being bound. */
    private fun capture(
        units: Map<String, Int>,
        textures: Map<Int, Int>,
        vararg events: CapturedEvent,
    ): Capture {
        val samplers = units.map { (name, unit) -> UniformValue(name, GL_SAMPLER_2D, floatArrayOf(unit.toFloat())) }
        val frame = plain.frames.single()
        val draws = frame.draws.map { it.copied(uniforms = samplers, textures = textures) }
        val frames = listOf(CapturedFrame(frame.moment, frame.time, draws, null))
        return Capture(plain.width, plain.height, plain.programs, plain.buffers, plain.textures, frames, events.toList())
    }

    @Test
    fun `a sampler that was never set finds nothing at unit 0`() {
        val never = capture(mapOf("emit" to 3, "diff" to 0, "spec" to 5), mapOf(3 to 0, 4 to 1, 5 to 2))
        assertEquals(setOf("diff"), SamplerFacts.of(never, 0).unbound)
        assertEquals(emptySet<String>(), SamplerFacts.of(capture(mapOf("emit" to 0, "diff" to 1), mapOf(0 to 0, 1 to 1)), 0).unbound)
    }

    @Test
    fun `nothing is said where textures may be missing from the capture`() {
        val event = CapturedEvent(EventKind.NOT_CAPTURED, 0, "a cube map")
        assertEquals(emptySet<String>(), SamplerFacts.of(capture(mapOf("diff" to 0), emptyMap(), event), 0).unbound)
    }

    @Test
    fun `files are told by the textures that a sampler reads`() {
        val event = CapturedEvent(EventKind.TEXTURE_FILE, -1, "1 ground diff.png")
        val read = capture(mapOf("emit" to 0, "diff" to 1), mapOf(0 to 0, 1 to 1), event)
        assertEquals(mapOf("diff" to setOf("ground diff.png")), SamplerFacts.of(read, 0).files)
    }
}
