package cga.grading.analysis

import cga.grading.capture.Capture
import cga.grading.findings.Place

/** The lines of a submission that its numbers were sent from. */
internal class SentFrom(private val capture: Capture) {
    private val uniforms = capture.draws.flatMap { it.uniforms }

    /** The file that hands numbers to OpenGL for all others, a class for shader programs: what is wrong is seldom in there. */
    private val setter: String? =
        uniforms
            .map { capture.chain(it.caller) }
            .filter { it.size > 1 }
            .map { Place.of(it.first()).file }
            .run { groupingBy { it }.eachCount().maxByOrNull { it.value }?.takeIf { it.value > size / 2 }?.key }

    /** Who sent the last value of [uniform], and who called them; the line first that names it. None where it was not sent. */
    fun places(uniform: String): List<Place> {
        val caller = uniforms.lastOrNull { it.name == uniform && it.caller >= 0 }?.caller ?: return emptyList()
        return places(caller)
    }

    /** The calls of the chain with the number [caller], beginning outside of the class for shader programs. */
    fun places(caller: Int): List<Place> {
        val chain = capture.chain(caller).map(Place::of)
        return chain.dropWhile { it.file == setter }.ifEmpty { chain }
    }
}
