package cga.grading.substitute

import cga.grading.capture.Capture

/**
 * The sheet's own lighting in the place of shaders that do not compile, so that the rest of a submission can be seen by it.
 *
 * What the submission sends to such a program is known, and under which names; what the names mean must be told from their words and from
 * the numbers. Where that cannot be done the stand-in stays.
 *
 * @property capture the one that was given, with the shaders replaced: its pictures are not the submission's.
 * @property isRead whether every program that a stand-in draws with is understood enough to be drawn with.
 * @property isWhole whether nothing that is sent to them was left over: then what is missing in their pictures was not sent.
 */
internal class Substitutes private constructor(
    val capture: Capture,
    val isRead: Boolean,
    val isWhole: Boolean,
) {
    companion object {
        fun of(capture: Capture): Substitutes {
            val stubs = capture.programs.indices.filter { capture.programs[it].substituted }.associateWith { Sent(capture, it) }
            val drawn = stubs.filterValues { it.frames.isNotEmpty() }
            val shaders = drawn.mapValues { (number, sent) -> SubstituteShaders.of(capture.programs[number], sent) }
            val programs = capture.programs.mapIndexed { number, program -> shaders[number]?.program ?: program }
            val replaced = capture.with(programs = programs)
            return Substitutes(
                if (drawn.isEmpty()) capture else replaced,
                shaders.values.none { it == null },
                shaders.values.all { it?.isWhole == true },
            )
        }
    }
}
