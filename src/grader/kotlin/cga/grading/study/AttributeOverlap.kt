package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedAttribute
import cga.grading.capture.GlNumbers

/** Whether a mesh has two vertex attributes in the same bytes, as where one offset is another's: then one of them is not what it should be. */
internal object AttributeOverlap {
    /** Whether that is so in any draw of program [number]. */
    fun isThere(
        capture: Capture,
        number: Int,
    ): Boolean =
        capture.drawsOf(number).any { draw ->
            draw.attributes.any { a -> draw.attributes.any { it.location > a.location && overlap(a, it) } }
        }

    /** A marker of positions alone has them for all else, too: nothing in its buffer is left out. */
    private fun overlap(
        a: CapturedAttribute,
        b: CapturedAttribute,
    ): Boolean =
        a.buffer == b.buffer && a.stride == b.stride && a.stride > maxOf(bytes(a), bytes(b)) &&
            a.offset < b.offset + bytes(b) && b.offset < a.offset + bytes(a)

    private fun bytes(attribute: CapturedAttribute) = attribute.size * (GlNumbers.attributeBytes(attribute.type) ?: 0)
}
