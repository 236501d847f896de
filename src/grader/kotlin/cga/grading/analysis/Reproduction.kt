package cga.grading.analysis

import cga.framework.RenderTarget
import cga.grading.capture.Capture
import cga.grading.capture.EventKind
import cga.grading.replay.Replay

/** Draws the captured pictures again: what the rest of the analysis measures must be what the submission showed. */
internal object Reproduction {
    /** Throws [NotReproducible] where a picture differs in a single byte: both were drawn by the same driver of the same machine. */
    fun check(capture: Capture, replay: Replay) {
        val drawn = capture.frames.withIndex().filter { it.value.picture != null }
        if (drawn.isEmpty()) return
        RenderTarget(capture.width, capture.height, capture.samples).use { target ->
            for ((number, frame) in drawn) {
                replay.draw(number, target)
                val wrong = differing(target.read().rgba, frame.picture ?: continue)
                if (wrong > 0) {
                    val pixels = "$wrong of ${capture.width * capture.height} pixels differ"
                    throw NotReproducible("frame not reproducible: at ${frame.moment.name.lowercase()} $pixels.${cause(capture)}")
                }
            }
        }
    }

    /** What was drawn with that a capture does not hold, as far as is known. */
    private fun cause(capture: Capture): String {
        val used = capture.events.filter { it.kind == EventKind.NOT_CAPTURED }.map { it.text }.distinct().take(MOST)
        return if (used.isEmpty()) "" else " It draws with what is not followed: ${used.joinToString()}."
    }

    private const val MOST = 3

    private fun differing(a: ByteArray, b: ByteArray): Int {
        if (a.contentEquals(b)) return 0
        return (0 until a.size / 4).count { pixel -> (0 until 3).any { a[4 * pixel + it] != b[4 * pixel + it] } }
    }
}
