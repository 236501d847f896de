package cga.grading.likeness

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.findings.Likeness
import cga.grading.findings.Part
import cga.grading.worker.withoutComments
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream

/** What is compared of a capture. */
internal object CaptureShape {
    /** The keys of [capture] and of its shaders, where some are the submission's. */
    fun keys(capture: Capture): Map<Part, String> {
        val shaders = capture.programs.filterNot { it.substituted }.map { shape(it.vertexSource) + "\n" + shape(it.fragmentSource) }
        val drawn = Part.CAPTURE to Likeness.keyOf(pieces(capture))
        return mapOf(drawn) + if (shaders.isEmpty()) emptyMap() else mapOf(Part.SHADERS to Likeness.keyOf(shaders.map(String::toByteArray)))
    }

    private fun shape(source: String) = CodeShape.of(withoutComments(source))

    /** The pictures, and frame by frame the values that were sent: in one order, whatever they are called. */
    private fun pieces(capture: Capture): List<ByteArray> =
        capture.frames.mapNotNull { it.picture } +
            capture.frames.mapIndexed { index, frame ->
                val bytes = ByteArrayOutputStream()
                DataOutputStream(bytes).run {
                    writeInt(index)
                    frame.draws.forEach { add(it) }
                }
                bytes.toByteArray()
            }

    private fun DataOutputStream.add(draw: CapturedDraw) {
        writeInt(draw.count)
        val values = draw.uniforms.map { value -> "${value.type} " + value.numbers.joinToString { "${it.toRawBits()}" } }
        values.sorted().forEach { write("$it\n".toByteArray()) }
    }
}
