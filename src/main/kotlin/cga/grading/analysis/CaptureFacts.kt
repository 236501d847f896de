package cga.grading.analysis

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.scene.ProgramFacts
import org.lwjgl.opengl.GL33C.GL_BOOL
import org.lwjgl.opengl.GL33C.GL_INT
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D

/** What a capture tells of its programs without running them. */
internal class CaptureFacts(private val capture: Capture) {
    private val draws = capture.frames.flatMap { it.steps }.filterIsInstance<CapturedDraw>()

    /** Names of the active uniforms. */
    val uniforms: Set<String> = draws.flatMap { it.uniforms }.map { it.name }.toSet()

    /** For the scene judge. */
    val program: ProgramFacts =
        ProgramFacts(
            unset = unset(),
            words = capture.programs
                .flatMap {
                    listOf(
                        it.vertexSource,
                        it.fragmentSource,
                    )
                }.flatMap { WORD.findAll(it) }
                .map { it.value }
                .toSet(),
            drawn = capture.frames.filter { frame -> frame.steps.any { it is CapturedDraw } }.map { it.moment }.toSet(),
            isReplaced = draws.isNotEmpty() && draws.all { capture.programs[it.program].substituted },
        )

    private fun unset(): Set<String> {
        val numbers = draws.flatMap { it.uniforms }.filter { it.type !in WHOLE }
        val set = numbers.filter { uniform -> uniform.numbers.any { it != 0f } }.map { it.name }.toSet()
        return numbers.map { it.name }.toSet() - set
    }

    private companion object {
        val WORD = Regex("[A-Za-z_]\\w*")

        /** Numbers for which 0 is as good as any. */
        val WHOLE = setOf(GL_SAMPLER_2D, GL_INT, GL_BOOL)
    }
}
