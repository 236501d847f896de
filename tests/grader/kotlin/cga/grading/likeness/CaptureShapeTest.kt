package cga.grading.likeness

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedProgram
import cga.grading.capture.SampleCapture
import cga.grading.capture.UniformValue
import cga.grading.findings.Part
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3

class CaptureShapeTest {
    private fun capture(draw: CapturedDraw, vararg programs: CapturedProgram) =
        SampleCapture.capture(steps = listOf(draw)).run { Capture(width, height, programs.toList(), buffers, textures, frames, events) }

    private fun program(fragment: String, substituted: Boolean = false) =
        CapturedProgram("void main() { }", fragment, emptyMap(), substituted = substituted)

    private val uniforms =
        listOf(UniformValue("color", GL_FLOAT_VEC3, floatArrayOf(1f, 2f, Float.NaN)), UniformValue("k", GL_FLOAT, floatArrayOf(60f)))

    private val keys = CaptureShape.keys(capture(SampleCapture.draw(uniforms = uniforms), program("float a = 1.0; // mine\n"), program("")))

    @Test
    fun `uniforms and variables of other names in another order are the same`() {
        val renamed = uniforms.reversed().map { UniformValue("farbe.${it.name}", it.type, it.numbers) }
        val same = capture(SampleCapture.draw(uniforms = renamed), program(" /* x */"), program("float  wert=1.;"))
        assertEquals(setOf(Part.SHADERS, Part.CAPTURE), keys.keys)
        assertEquals(keys, CaptureShape.keys(same))
    }

    @Test
    fun `another value is another capture, another formula other shaders`() {
        val brighter = uniforms.map { UniformValue(it.name, it.type, it.numbers.map { x -> x * 2 }.toFloatArray()) }
        val other = CaptureShape.keys(capture(SampleCapture.draw(uniforms = brighter), program("float a = 1.0 + a;"), program("")))
        for (part in keys.keys) assertNotEquals(keys[part], other[part], part.id)
    }

    @Test
    fun `shaders of ours that stand in for broken ones are nobody's`() {
        val broken = capture(SampleCapture.draw(), program("float a;", substituted = true))
        assertEquals(setOf(Part.CAPTURE), CaptureShape.keys(broken).keys)
    }
}
